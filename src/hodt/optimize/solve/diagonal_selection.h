// Quadrilaterals' diagonals chosen so that no vertex gets too many.
// Tested by tests/optimize/minimize_degree_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "hodt/base/buffer.h"
#include "hodt/base/deadline.h"
#include "hodt/base/ids.h"

namespace hodt {

/// One diagonal of every quadrilateral: it adds 1 at two of the four vertices.
class DiagonalSelection {
 public:
  using Corners = std::array<VertexId, 4>;  // ends of the first diagonal, then of the other

  /// `base`: the degree of every vertex without any of the diagonals.
  DiagonalSelection(Buffer<Index> base, std::vector<Corners> quadrilaterals);

  enum class Answer { possible, impossible, unknown };
  /// Chooses so that no vertex has a degree above `most`. `chosen` (true: the second diagonal) is
  /// changed only if that is possible, and only where it must be. Backtracking with propagation, up
  /// to a fixed amount of work for each part, or until the deadline.
  Answer keep_below(Index most, std::vector<bool>& chosen, const Deadline& deadline = {}) const;

 private:
  class Search;

  Buffer<Index> base_;
  std::vector<Corners> quadrilaterals_;
  std::vector<std::vector<Index>> quadrilaterals_at_;
};

}  // namespace hodt
