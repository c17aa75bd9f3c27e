#include "app/comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "app/mean_angle.h"
#include "app/unchanged.h"
#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/optimize/value_of.h"
#include "hodt/tin/interpolate.h"
#include "hodt/tin/quality.h"

namespace hodt::app {

namespace {

double smallest_angle(const Tin& tin) {
  double smallest = 180;
  for (const auto& [u, v, w] : tin.triangles) {
    const Point &a = tin.points.xy[u], &b = tin.points.xy[v], &c = tin.points.xy[w];
    smallest = std::min({smallest, angle_at(a, b, c), angle_at(b, c, a), angle_at(c, a, b)});
  }
  return smallest;
}

/// Part of the whole in percent; nothing of nothing is 0.
std::optional<double> percent(double part, double whole) {
  if (part == 0) return 0;
  const double share = 100 * part / std::fabs(whole);
  return std::isfinite(share) ? std::optional(share) : std::nullopt;
}

/// The differences between surface and truth, summed up.
class Errors {
 public:
  Errors(const Tin& tin, const PointSet& truth) {
    const std::vector<double> heights = interpolate(tin, truth.xy);
    for (std::size_t i = 0; i < heights.size(); ++i)
      if (!std::isnan(heights[i])) add(heights[i] - truth.z[i]);
  }

  std::size_t count() const { return count_; }
  std::optional<Fit> fit() const {
    if (count_ == 0) return std::nullopt;
    return Fit{std::sqrt(squares_ / static_cast<double>(count_)), largest_};
  }

 private:
  void add(double error) {
    ++count_;
    squares_ += error * error;
    largest_ = std::max(largest_, std::fabs(error));
  }

  std::size_t count_ = 0;
  double squares_ = 0;
  double largest_ = 0;
};

class Comparer {
 public:
  Comparer(const PointSet& points, const PointSet* truth, const ComparisonOptions& options,
           const Constraints& constraints)
      : points_(points), truth_(truth), options_(options), constraints_(constraints) {
    if (truth && options.truth_grid) land_.emplace(*options.truth_grid, *truth);
  }

  Comparison run() {
    Prepared prepared = prepare(points_,
                                {.min_pit_depth = options_.min_pit_depth,
                                 .keep = options_.keep,
                                 .progress = options_.progress},
                                constraints_);
    prepared.report.seconds = {};  // of each row its own

    Comparison comparison;
    comparison.points = points_.size();
    comparison.duplicates = prepared.report.duplicates;
    comparison.duplicate_heights = prepared.report.duplicate_heights;
    comparison.empty_polygons = prepared.keep.empty_polygons;
    if (!prepared.keep.is_kept.empty()) comparison.kept = prepared.keep.count;
    comparison.constraints = prepared.report.constraints;
    if (prepared.report.given) comparison.given_order = prepared.report.given->order;
    comparison.orders = options_.orders;
    const TriangulateResult delaunay = triangulated(prepared, {Objective::none}, 0);
    comparison.delaunay_pits = delaunay.report.pits;
    if (truth_) comparison.truth = truth_summary(delaunay.tin);
    for (const std::vector<Objective>& objectives : options_.objectives) {
      ObjectiveComparison rows = compared(prepared, objectives);
      rows.why_unchanged = why_unchanged(rows, prepared.delaunay);
      comparison.objectives.push_back(std::move(rows));
    }
    return comparison;
  }

 private:
  TruthSummary truth_summary(const Tin& delaunay) {
    const Errors errors(delaunay, *truth_);
    TruthSummary summary{truth_->size(), truth_->size() - errors.count(), errors.fit()};
    if (!land_) return summary;
    summary.delaunay_land = land_->fit_of(delaunay);
    summary.land_fill = land_->fill();
    return summary;
  }

  ObjectiveComparison compared(const Prepared& prepared, const std::vector<Objective>& objectives) {
    ObjectiveComparison comparison{objectives, {}};
    for (const Index k : options_.orders) {
      const TriangulateResult result = triangulated(prepared, objectives, k);
      comparison.rows.push_back(row(result));
      if (const auto& given = result.report.given) {
        comparison.given = given->then;
        comparison.given.insert(comparison.given.begin(), given->value);
      }
    }
    return comparison;
  }

  TriangulateResult triangulated(const Prepared& prepared, const std::vector<Objective>& objectives,
                                 Index k) const {
    TriangulateOptions options;
    options.order = k;
    options.objective = objectives.front();
    options.then.assign(objectives.begin() + 1, objectives.end());
    options.time_limit = options_.time_limit;
    options.measure_pits = true;
    if (options_.progress) {
      options.progress = [&, name = name_of(options.objective), k](std::string_view phase,
                                                                   double done) {
        options_.progress(fmt::format("{}, k = {}, {}", name, k, phase), done);
      };
    }
    return triangulate(points_, prepared, options);
  }

  ComparisonRow row(const TriangulateResult& result) {
    const Report& report = result.report;
    ComparisonRow row;
    row.k = report.k;
    row.value = *report.value;
    row.then = report.then;
    if (const auto count = angles_in_sum(report)) row.mean_angle = row.value.result / *count;
    row.order = report.order;
    row.smallest_angle = smallest_angle(result.tin);
    if (report.extrema_result) row.local_minima = report.extrema_result->minima.total();
    row.pits = report.pits;
    if (truth_) row.fit = Errors(result.tin, *truth_).fit();
    if (land_) row.land = land_->fit_of(result.tin);
    row.seconds = report.seconds.optimize;
    return row;
  }

  const PointSet& points_;
  const PointSet* truth_;
  std::optional<Land> land_;
  const ComparisonOptions& options_;
  const Constraints& constraints_;
};

/// By the first of the objectives that tells them apart.
bool is_better_row(const std::vector<Objective>& objectives, const ComparisonRow& row,
                   const ComparisonRow& than) {
  if (row.value.result != than.value.result)
    return is_better(objectives.front(), row.value.result, than.value.result);
  for (std::size_t i = 0; i < row.then.size(); ++i)
    if (const double value = row.then[i].value.result; value != than.then[i].value.result)
      return is_better(objectives[i + 1], value, than.then[i].value.result);
  return false;
}

}  // namespace

std::optional<double> ComparisonRow::gap() const {
  if (value.optimal) return 0;
  return percent(std::fabs(value.result - value.bound), value.result);
}

std::optional<double> ComparisonRow::change() const {
  return percent(value.result - value.delaunay, value.delaunay);
}

ComparisonRow ComparisonRow::by_later(std::size_t i) const {
  ComparisonRow later = *this;
  later.value = then[i].value;
  later.then.clear();
  later.mean_angle.reset();
  return later;
}

std::string ObjectiveComparison::title() const {
  return names_of(objectives, ", then ");
}

const ComparisonRow& ObjectiveComparison::best() const {
  return *std::min_element(rows.begin(), rows.end(), [&](const auto& a, const auto& b) {
    return is_better_row(objectives, a, b);
  });
}

ObjectiveComparison ObjectiveComparison::by_later(std::size_t i) const {
  ObjectiveComparison later{{objectives[i + 1]}, {}};
  for (const ComparisonRow& row : rows) later.rows.push_back(row.by_later(i));
  if (!given.empty()) later.given = {given[i + 1]};
  return later;
}

std::vector<Objective> compared_objectives(std::string names) {
  std::replace(names.begin(), names.end(), '+', ',');
  std::vector<Objective> objectives = objectives_from_names(names);
  if (objectives.front() == Objective::none)
    throw ParameterError("the objective none has nothing to compare; name another, or all");
  return objectives;
}

Comparison compare(const PointSet& points, const PointSet* truth, const ComparisonOptions& options,
                   const Constraints& constraints) {
  return Comparer(points, truth, options, constraints).run();
}

}  // namespace hodt::app
