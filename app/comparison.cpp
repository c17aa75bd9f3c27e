#include "app/comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "app/mean_angle.h"
#include "app/unchanged.h"
#include <fmt/format.h>

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
  Comparer(const PointSet& points, const PointSet* truth, const ComparisonOptions& options)
      : points_(points), truth_(truth), options_(options) {}

  Comparison run() const {
    Prepared prepared = prepare(points_, {.min_pit_depth = options_.min_pit_depth,
                                          .keep = options_.keep,
                                          .progress = options_.progress});
    prepared.report.seconds = {};  // of each row its own

    Comparison comparison;
    comparison.points = points_.size();
    comparison.duplicates = prepared.report.duplicates;
    comparison.duplicate_heights = prepared.report.duplicate_heights;
    comparison.empty_polygons = prepared.keep.empty_polygons;
    if (!prepared.keep.is_kept.empty()) comparison.kept = prepared.keep.count;
    comparison.orders = options_.orders;
    const TriangulateResult delaunay = triangulated(prepared, Objective::none, 0);
    comparison.delaunay_pits = delaunay.report.pits;
    if (truth_) comparison.truth = truth_summary(delaunay.tin);
    for (const Objective& objective : options_.objectives) {
      ObjectiveComparison rows = compared(prepared, objective);
      rows.why_unchanged = why_unchanged(rows, prepared.delaunay);
      comparison.objectives.push_back(std::move(rows));
    }
    return comparison;
  }

 private:
  TruthSummary truth_summary(const Tin& delaunay) const {
    const Errors errors(delaunay, *truth_);
    return {truth_->size(), truth_->size() - errors.count(), errors.fit()};
  }

  ObjectiveComparison compared(const Prepared& prepared, const Objective& objective) const {
    ObjectiveComparison comparison{objective, {}};
    for (const Index k : options_.orders)
      comparison.rows.push_back(row(triangulated(prepared, objective, k)));
    return comparison;
  }

  TriangulateResult triangulated(const Prepared& prepared, const Objective& objective,
                                 Index k) const {
    TriangulateOptions options;
    options.order = k;
    options.objective = objective;
    options.time_limit = options_.time_limit;
    options.measure_pits = true;
    if (options_.progress) {
      options.progress = [&, name = name_of(objective), k](std::string_view phase, double done) {
        options_.progress(fmt::format("{}, k = {}, {}", name, k, phase), done);
      };
    }
    return triangulate(points_, prepared, options);
  }

  ComparisonRow row(const TriangulateResult& result) const {
    const Report& report = result.report;
    ComparisonRow row;
    row.k = report.k;
    row.value = *report.value;
    if (const auto count = angles_in_sum(report)) row.mean_angle = row.value.result / *count;
    row.order = report.order;
    row.smallest_angle = smallest_angle(result.tin);
    if (report.extrema_result) row.local_minima = report.extrema_result->minima.total();
    row.pits = report.pits;
    if (truth_) row.fit = Errors(result.tin, *truth_).fit();
    row.seconds = report.seconds.optimize;
    return row;
  }

  const PointSet& points_;
  const PointSet* truth_;
  const ComparisonOptions& options_;
};

}  // namespace

std::optional<double> ComparisonRow::gap() const {
  if (value.optimal) return 0;
  return percent(std::fabs(value.result - value.bound), value.result);
}

std::optional<double> ComparisonRow::change() const {
  return percent(value.result - value.delaunay, value.delaunay);
}

const ComparisonRow& ObjectiveComparison::best() const {
  const bool maximizes =
      objective.kind == Objective::measured && objective.direction == Direction::maximize;
  return *std::min_element(rows.begin(), rows.end(), [&](const auto& a, const auto& b) {
    return maximizes ? a.value.result > b.value.result : a.value.result < b.value.result;
  });
}

Comparison compare(const PointSet& points, const PointSet* truth,
                   const ComparisonOptions& options) {
  return Comparer(points, truth, options).run();
}

}  // namespace hodt::app
