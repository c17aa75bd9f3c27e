// The whole job: points in, a higher order Delaunay TIN out.
// Tested by tests/exhaustive/pipeline_small_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/base/progress.h"
#include "hodt/delaunay/delaunay.h"
#include "hodt/geometry/constraints.h"
#include "hodt/geometry/places.h"
#include "hodt/geometry/point_set.h"
#include "hodt/hydrology/minima_to_keep.h"
#include "hodt/hydrology/pit_water.h"
#include "hodt/optimize/optimize.h"
#include "hodt/pipeline/what_changed.h"
#include "hodt/tin/extrema.h"
#include "hodt/tin/tin.h"

namespace hodt {

struct TriangulateOptions {
  /// The order k: no circumcircle of the result holds more than k points. Larger than n - 3 means
  /// unrestricted.
  Index order = 4;
  Objective objective = Objective::min_local_minima;
  /// What else to optimise for, one after the other, among the triangulations that are as good for
  /// the objectives before (see optimize_in_order).
  std::vector<Objective> then = {};
  Method method = Method::automatic;
  /// Seconds that searching may take; 0: a fixed amount of work, the same on every machine.
  double time_limit = 0;
  /// Real pits that stay, for min-local-minima and min-local-extrema as (first) objective: local
  /// minima of the Delaunay triangulation that are at least so deep (see pit_depths.h; 0: all may
  /// go), and those that one of the points drains to or one of the polygons contains.
  double min_pit_depth = 0;
  Places keep = {};
  /// Whether the report says how deep the pits are and what they hold. The flood for it takes
  /// longer than the triangulation.
  bool measure_pits = false;
  /// Whether the TIN tells the order of each triangle.
  bool tell_orders = false;
  /// Whether the result says what happened to the Delaunay triangulation. Tells the orders, too.
  bool tell_changes = false;
  /// Whether the report has the Delaunay triangulation, too.
  bool tell_delaunay = false;
  /// Told what the job is doing; may be empty.
  Progress progress = {};
};

struct Seconds {
  double read = 0;
  /// From coordinates in input order to triangles and neighbours in input numbering.
  double delaunay = 0;
  /// With the bound and the verification.
  double optimize = 0;
  double write = 0;
};

struct Report {
  std::size_t points = 0;      ///< data rows of the input
  std::size_t duplicates = 0;  ///< rows dropped because another has the same (x, y)
  std::optional<DuplicateHeights> duplicate_heights;  ///< empty if the input has no heights
  std::size_t triangles = 0;
  Index k = 0;
  /// The largest order of a triangle of the result.
  Index order = 0;
  /// How many triangles of the result have order 0, 1, ..., `order`.
  std::vector<std::size_t> order_histogram;
  Objective objective = Objective::none;
  /// Local minima that were to stay.
  std::size_t kept = 0;
  /// Polygons to keep minima in that no point is in.
  std::size_t empty_polygons = 0;
  std::optional<Value> value;         ///< empty for Objective::none
  std::vector<LaterValue> then = {};  ///< of the other objectives
  /// What constraints did; nothing without any.
  ConstraintReport constraints;
  /// Of the triangulation that was there already, if there was one: its (constrained) order, and
  /// the objective's value, which is 0 for Objective::none.
  struct Given {
    Index order = 0;
    double value = 0;
    std::vector<double> then = {};  ///< of the other objectives
    bool is_kept = false;           ///< nothing better was found: it is the result
  };
  std::optional<Given> given;
  /// Of the Delaunay triangulation and of the result; empty if the input has no heights.
  std::optional<ExtremaCount> extrema_delaunay;
  std::optional<ExtremaCount> extrema_result;
  /// Of the result; empty also if options.measure_pits is not set. For those of the Delaunay
  /// triangulation ask for Objective::none.
  std::optional<PitTotals> pits;
  /// Nothing unless options.tell_changes.
  WhatChanged changes = {};
  /// The triangles of the (constrained) Delaunay triangulation, with the vertices of the TIN; none
  /// unless options.tell_delaunay.
  std::vector<std::array<Index, 3>> delaunay = {};
  Seconds seconds;
};

struct TriangulateResult {
  /// Vertices in input order, dropped duplicates left out: if there are none, vertex i is row i of
  /// the points. Points that constraints leave no triangle are left out, too.
  Tin tin;
  Report report;
};

/// Triangulates the points, every triangle of order at most options.order, as good for the
/// objective as hodt can. Throws InputError if there is no triangle (fewer than three distinct
/// points, or all on a line), a coordinate is not finite, what the objective measures is out of a
/// double's range, or the places to keep cannot be on the points' map (see check_places.h);
/// ParameterError if the objective needs heights and the points have none, or the objectives cannot
/// be asked for in order. Fills all of the report
/// but seconds.read and seconds.write.
///
/// With constraints the triangulation has their edges, and only the triangles of their domain;
/// orders are constrained orders (docs/definitions.md): no circle counts what is beyond an edge
/// that has to be there. Delaunay, here and in the report, then means the constrained Delaunay
/// triangulation. Throws what constrain() throws, too (see pipeline/constrain.h).
TriangulateResult triangulate(const PointSet& points, const TriangulateOptions& options = {},
                              const Constraints& constraints = {});

/// What triangulate() begins with, whatever the order and the objective.
struct Prepared {
  Delaunay delaunay;
  /// The triangulation that was there already, on the same vertices.
  std::optional<TriangleMesh> given;
  MinimaToKeep keep;
  /// As far as it is known.
  Report report;
};

/// Looks at options.min_pit_depth, .keep and .progress only. Throws what triangulate() throws.
Prepared prepare(const PointSet& points, const TriangulateOptions& options = {},
                 const Constraints& constraints = {});

/// The rest of the job, on a Delaunay triangulation of its own: for many orders and objectives,
/// pass copies. Does not look at options.min_pit_depth and .keep again; objectives that do not
/// count minima have none to keep.
TriangulateResult triangulate(const PointSet& points, Prepared prepared,
                              const TriangulateOptions& options);

}  // namespace hodt
