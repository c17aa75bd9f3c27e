#include "hodt/io/point_doubts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "hodt/base/parallel.h"

namespace hodt {

namespace {

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

Range range_of(const std::vector<double>& values) {
  constexpr std::size_t grain = std::size_t{1} << 16;
  const auto find = [&](std::size_t first, std::size_t last, std::vector<Range>& found) {
    Range range;
    for (std::size_t i = first; i < last; ++i) range.add(values[i]);
    found.push_back(range);
  };
  Range all;
  for (const Range& range : parallel_collect<Range>(0, values.size(), grain, find)) {
    all.low = std::min(all.low, range.low);
    all.high = std::max(all.high, range.high);
  }
  return all;
}

/// What programs write where there is no height. As far as possible each is the smallest or the
/// largest height of its file.
bool means_no_data(double z) {
  const double size = std::abs(z);
  const bool float_limit = size > 3.4028e38 && size < 3.4029e38;
  const bool double_limit = size > 1.7976e308;
  const bool surfer = size > 1.70140e38 && size < 1.70142e38;
  const bool netcdf = size > 9.9692e36 && size < 9.9693e36;
  if (float_limit || double_limit || surfer || netcdf || size >= 1e20) return true;
  for (const double value :
       {-9999.0, -99999.0, -999999.0, -32768.0, -32767.0, -9999.9, -999.25, -2147483648.0,
        -2147483647.0, 9999.0, 99999.0, 999999.0, 32767.0, 65535.0, -999.0, -9999.99})
    if (z == value) return true;
  return false;
}

/// How many heights are this one, and where all others lie.
std::pair<std::size_t, Range> split_at(const std::vector<double>& heights, double value) {
  std::size_t count = 0;
  Range others;
  for (const double z : heights) z == value ? void(++count) : others.add(z);
  return {count, others};
}

}  // namespace

bool x_counts(const PointSet& points) {
  const auto& xy = points.xy;
  if (xy.size() < 3 || xy[0].x != std::floor(xy[0].x)) return false;
  for (std::size_t i = 1; i < xy.size(); ++i)
    if (xy[i].x != xy[i - 1].x + 1) return false;
  return true;
}

bool x_could_number_points(const PointSet& points) {
  bool whole_y = true;
  for (const Point& p : points.xy) {
    if (p.x != std::floor(p.x)) return false;
    whole_y = whole_y && p.y == std::floor(p.y);
  }
  if (!whole_y) return true;
  std::vector<double> xs;
  for (const Point& p : points.xy) xs.push_back(p.x);
  std::sort(xs.begin(), xs.end());
  return std::adjacent_find(xs.begin(), xs.end()) == xs.end();
}

std::vector<std::string> warn_of_no_data(const PointSet& points) {
  std::vector<std::string> warnings;
  if (!points.has_heights()) return warnings;
  const Range all = range_of(points.z);
  for (const double end : {all.low, all.high}) {
    if (!means_no_data(end)) continue;
    const auto [count, others] = split_at(points.z, end);
    if (count == points.size()) continue;
    const double gap = std::max(others.low - end, end - others.high);
    const bool many = count >= std::max<std::size_t>(10, points.size() / 1000);
    if (!many && gap <= others.high - others.low) continue;
    warnings.push_back(fmt::format(
        "{} of {} heights {} {}, which usually means that there is none; remove those rows", count,
        points.size(), count == 1 ? "is" : "are", end));
  }
  return warnings;
}

}  // namespace hodt
