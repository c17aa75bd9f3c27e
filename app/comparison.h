// What every order gains, for some objectives: the numbers behind `hodt compare`.
// Tested by tests/app/compare_test.cpp.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/base/progress.h"
#include "hodt/geometry/point_set.h"
#include "hodt/optimize/objective.h"
#include "hodt/pipeline.h"

namespace hodt::app {

/// How far the surface is from heights that are known.
struct Fit {
  double rmse = 0;
  double max_error = 0;
};

/// One triangulation.
struct ComparisonRow {
  Index k = 0;
  Value value;
  std::optional<double> mean_angle;  ///< of a sum of angles, in degrees
  Index order = 0;
  /// Of the whole mesh, in degrees.
  double smallest_angle = 0;
  std::optional<std::size_t> local_minima;  ///< empty without heights
  std::optional<PitTotals> pits;            ///< likewise
  std::optional<Fit> fit;                   ///< empty without truth inside the hull
  double seconds = 0;

  /// Of the result to the bound, in percent of the result; empty if the result is 0 and not
  /// optimal.
  std::optional<double> gap() const;
  /// Against the Delaunay triangulation, in percent of its value; empty if that is 0 and changes.
  std::optional<double> change() const;
};

struct ObjectiveComparison {
  Objective objective;
  std::vector<ComparisonRow> rows;  ///< one an order
  std::string why_unchanged = {};   ///< see unchanged.h

  /// The row with the best value, the first of these.
  const ComparisonRow& best() const;
};

/// The truth points, and how the Delaunay triangulation fits them.
struct TruthSummary {
  std::size_t points = 0;
  std::size_t outside = 0;  ///< of the hull: not compared with
  std::optional<Fit> delaunay;
};

struct Comparison {
  std::size_t points = 0;
  std::size_t duplicates = 0;
  std::optional<DuplicateHeights> duplicate_heights;  ///< empty without heights
  std::optional<std::size_t> kept;                    ///< minima; empty if none were asked for
  std::size_t empty_polygons = 0;
  std::vector<Index> orders;
  std::optional<PitTotals> delaunay_pits;  ///< empty without heights
  std::optional<TruthSummary> truth;
  std::vector<ObjectiveComparison> objectives;
};

struct ComparisonOptions {
  std::vector<Index> orders;
  std::vector<Objective> objectives;
  /// Seconds that one search may take; 0: no limit.
  double time_limit = 0;
  /// As in TriangulateOptions, for the objectives that count minima.
  double min_pit_depth = 0;
  Places keep;
  Progress progress;
};

/// Triangulates the points for every objective and order. `truth`, points with heights, may be
/// null. Throws what triangulate() throws.
Comparison compare(const PointSet& points, const PointSet* truth, const ComparisonOptions& options);

}  // namespace hodt::app
