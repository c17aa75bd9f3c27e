#include "hodt/io/local_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hodt/base/error.h"
#include "hodt/io/tin_parts.h"

namespace hodt {

namespace {

std::array<double, 3> place_of(const PointSet& points, std::size_t i) {
  return {points.xy[i].x, points.xy[i].y, height_or_zero(points, i)};
}

/// The middle of what there is of coordinate k, as a whole number.
double middle(const PointSet& points, std::size_t k) {
  double least = std::numeric_limits<double>::max(), most = -least;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double value = place_of(points, i)[k];
    least = std::min(least, value);
    most = std::max(most, value);
  }
  // Not minus zero, which would be written.
  return points.size() == 0 ? 0 : std::round(least / 2 + most / 2) + 0.0;
}

}  // namespace

LocalFrame::LocalFrame(const Tin& tin) : points_(tin.points) {
  for (std::size_t k = 0; k < 3; ++k) origin_[k] = middle(points_, k);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const auto exact = place_of(points_, i);
    const auto stored = (*this)[i];
    for (std::size_t k = 0; k < 3; ++k) {
      if (!std::isfinite(stored[k]))
        throw InputError(
            "the format holds numbers of single precision, and the mesh extends further than "
            "these do; write .ply, which holds doubles");
      const double local = exact[k] - origin_[k];
      // What the subtraction took away, too.
      const double lost = std::fabs(exact[k] - (origin_[k] + local));
      largest_error_ = std::max(largest_error_, std::fabs(local - double{stored[k]}) + lost);
    }
  }
}

std::array<float, 3> LocalFrame::operator[](std::size_t vertex) const {
  const auto exact = place_of(points_, vertex);
  std::array<float, 3> local;
  for (std::size_t k = 0; k < 3; ++k) local[k] = static_cast<float>(exact[k] - origin_[k]);
  return local;
}

}  // namespace hodt
