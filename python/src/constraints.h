// Breaklines, outlines and places to keep, as they come from Python.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/geometry/places.h"
#include "hodt/pipeline/constrain.h"
#include "hodt/pipeline/join_lines.h"

namespace hodt::python {

/// What hodt.Constraints holds. Coordinates are finite and rows are rows: Python looks at that.
struct ConstraintInput {
  Lines breaklines{{}, "breaklines", "line"};
  Outline outline{{}, "outline", "ring"};
  std::vector<Constraints::Edge> edges, boundary;  ///< by rows of the points
  double max_edge = std::numeric_limits<double>::infinity();
  JoinOptions options;

  bool has_lines() const { return !breaklines.lines.empty() || !outline.rings.empty(); }
  bool any() const {
    return has_lines() || !edges.empty() || !boundary.empty() ||
           max_edge < std::numeric_limits<double>::infinity();
  }
  Joined join(PointSet points) const;
};

void add_constraint_input(nb::module_& module);

/// From None or a hodt.Places.
Places keep_of(nb::handle keep);

/// f(), where what it says of lines that cross names them.
template <class F>
auto naming_lines(const Joined& joined, const F& f) {
  try {
    return f();
  } catch (const CrossingError& error) {
    if (joined.origins.empty()) throw;
    throw InputError(crossing_text(joined, error.crossings().front()) +
                     "; mend them, or use split_crossings=True for a vertex where lines cross");
  }
}

}  // namespace hodt::python
