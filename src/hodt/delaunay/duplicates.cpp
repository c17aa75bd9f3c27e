#include "hodt/delaunay/duplicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "hodt/base/buffer.h"
#include "hodt/base/error.h"
#include "hodt/base/exact_sum.h"
#include "hodt/delaunay/spatial_order.h"

namespace hodt {

namespace {

constexpr std::array<const char*, 5> kNames = {"lowest", "highest", "mean", "first", "error"};

/// Calls f with the rows at each place that has several, in ascending order.
template <class F>
void for_each_place(const PointSet& points, const VertexSet& vertices, const F& f) {
  const Buffer<VertexId> vertex_of = vertices_of_rows(points, vertices);
  std::vector<Index> count(vertices.size(), 0);
  for (const VertexId v : vertex_of) ++count[v];
  std::vector<Index> rows;  // those at one place side by side
  for (Index row = 0; row < points.size(); ++row)
    if (count[vertex_of[row]] > 1) rows.push_back(row);
  std::stable_sort(rows.begin(), rows.end(),
                   [&](Index a, Index b) { return Index(vertex_of[a]) < Index(vertex_of[b]); });
  for (std::size_t first = 0; first < rows.size();) {
    const std::size_t size = count[vertex_of[rows[first]]];
    f(std::span<const Index>(rows).subspan(first, size));
    first += size;
  }
}

[[noreturn]] void refuse(const PointSet& points, const VertexSet& vertices) {
  std::array<Index, 2> first = {kNone, kNone};
  for_each_place(points, vertices, [&](std::span<const Index> rows) {
    first = std::min(first, {rows[0], rows[1]});
  });
  const Point& p = points.xy[first[0]];
  throw InputError(fmt::format(
      "points {} and {} (counted from 0) have the same x and y, {} and {}; remove one of them, or "
      "say with --duplicates which height counts",
      first[0], first[1], p.x, p.y));
}

double mean(const std::vector<double>& z) {
  ExactSum sum;
  sum.add(z);
  const double total = sum.nearest(), size = static_cast<double>(z.size());
  if (std::isfinite(total)) return total / size;
  double parts = 0;  // of heights at the end of a double's range
  for (const double value : z) parts += value / size;
  return parts;
}

double height_by(DuplicateRule rule, const std::vector<double>& z) {
  if (rule == DuplicateRule::first) return z.front();
  const auto [low, high] = std::minmax_element(z.begin(), z.end());
  if (rule == DuplicateRule::mean) return std::clamp(mean(z), *low, *high);
  return rule == DuplicateRule::highest ? *high : *low;
}

}  // namespace

DuplicateHeights settle_duplicates(PointSet& points, DuplicateRule rule) {
  DuplicateHeights heights{0, 0, rule};
  if (rule == DuplicateRule::lowest) return heights;
  if (!points.has_heights() && rule != DuplicateRule::error) return heights;
  const VertexSet vertices = spatial_order(points).vertices;
  if (vertices.size() == points.size()) return heights;
  if (rule == DuplicateRule::error) refuse(points, vertices);
  std::vector<double> z;
  for_each_place(points, vertices, [&](std::span<const Index> rows) {
    z.clear();
    for (const Index row : rows) z.push_back(points.z[row]);
    const double height = height_by(rule, z);
    for (const Index row : rows) {
      const double difference = std::fabs(points.z[row] - height);
      heights.different += difference > 0;
      heights.largest_difference = std::max(heights.largest_difference, difference);
      points.z[row] = height;
    }
  });
  return heights;
}

std::string name_of(DuplicateRule rule) {
  return kNames[static_cast<std::size_t>(rule)];
}

DuplicateRule duplicate_rule(const std::string& option, const std::string& name) {
  const auto at = std::find(kNames.begin(), kNames.end(), name);
  if (at == kNames.end())
    throw ParameterError(
        fmt::format("{} must be lowest, highest, mean, first or error, not '{}'", option, name));
  return static_cast<DuplicateRule>(at - kNames.begin());
}

}  // namespace hodt
