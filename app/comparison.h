// What every order gains, for some objectives: the numbers behind `hodt compare`.
// Tested by tests/app/compare_test.cpp.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/land.h"

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
  std::vector<LaterValue> then;      ///< of the objectives after the first
  std::optional<double> mean_angle;  ///< of a sum of angles, in degrees
  Index order = 0;
  /// Of the whole mesh, in degrees.
  double smallest_angle = 0;
  std::optional<std::size_t> local_minima;  ///< empty without heights
  std::optional<PitTotals> pits;            ///< likewise
  std::optional<Fit> fit;                   ///< empty without truth inside the hull
  std::optional<LandFit> land;              ///< empty unless the truth is a raster
  double seconds = 0;

  /// Of the result to the bound, in percent of the result; empty if the result is 0 and not
  /// optimal.
  std::optional<double> gap() const;
  /// Against the Delaunay triangulation, in percent of its value; empty if that is 0 and changes.
  std::optional<double> change() const;
  /// The same triangulation by one of the other objectives: as if `value` were of that one.
  ComparisonRow by_later(std::size_t i) const;
};

/// Of one objective, or of several in order.
struct ObjectiveComparison {
  std::vector<Objective> objectives;  ///< each among the triangulations as good for those before
  std::vector<ComparisonRow> rows;    ///< one an order
  std::vector<double> given = {};  ///< of a mesh that was there already: values of the objectives
  std::string why_unchanged = {};  ///< see unchanged.h

  const Objective& objective() const { return objectives.front(); }
  /// "min-max-angle", "min-max-angle, then min-sum-length".
  std::string title() const;
  /// The row with the best values, the first of these.
  const ComparisonRow& best() const;
  /// The same of all rows.
  ObjectiveComparison by_later(std::size_t i) const;
};

/// The truth points, and how the Delaunay triangulation fits them.
struct TruthSummary {
  std::size_t points = 0;
  std::size_t outside = 0;  ///< of the hull: not compared with
  std::optional<Fit> delaunay;
  std::optional<LandFit> delaunay_land = {};  ///< of a raster
  FillTotals land_fill = {};                  ///< likewise: of its own pits
};

struct Comparison {
  std::size_t points = 0;
  std::size_t duplicates = 0;
  std::optional<DuplicateHeights> duplicate_heights;  ///< empty without heights
  std::optional<std::size_t> kept;                    ///< minima; empty if none were asked for
  std::size_t empty_polygons = 0;
  ConstraintReport constraints;      ///< nothing without any
  std::optional<Index> given_order;  ///< of a mesh that was there already
  std::vector<Index> orders;
  std::optional<PitTotals> delaunay_pits;  ///< empty without heights
  std::optional<TruthSummary> truth;
  std::vector<ObjectiveComparison> objectives;
};

struct ComparisonOptions {
  std::vector<Index> orders;
  /// Each one or several in order.
  std::vector<std::vector<Objective>> objectives;
  /// Seconds that one search may take; 0: no limit.
  double time_limit = 0;
  /// As in TriangulateOptions, for (first) objectives that count minima.
  double min_pit_depth = 0;
  Places keep;
  /// If the points of the truth are the centres of a raster's cells.
  std::optional<Grid> truth_grid = {};
  Progress progress;
};

/// Objectives in order from their names with a plus between, like
/// "min-local-minima+min-sum-length". Throws ParameterError for what is none, or cannot be
/// compared.
std::vector<Objective> compared_objectives(std::string names);

/// Triangulates the points for all objectives and orders. `truth`, points with heights, may be
/// null. Throws what triangulate() throws.
Comparison compare(const PointSet& points, const PointSet* truth, const ComparisonOptions& options,
                   const Constraints& constraints = {});

}  // namespace hodt::app
