#include "hodt/optimize/measure/edge_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "hodt/base/lanes.h"
#include "hodt/base/parallel.h"
#include "hodt/geometry/wide_real.h"
#include "hodt/optimize/measure/angle.h"
#include "hodt/optimize/range.h"

namespace hodt {

namespace {

// What is measured across one edge, with the vector (x, y) along it, between planes with these
// gradients. All is inlined into loops over many edges (see measures.cpp).

HODT_INLINE double sqrt_of(double x) {
  return std::sqrt(x);
}
HODT_INLINE double size_of(double x) {
  return std::fabs(x);
}
HODT_INLINE double undefined_if_infinite(double x) {
  return 0 * x;
}
WideReal sqrt_of(const WideReal& x) {
  return sqrt(x);
}
WideReal size_of(const WideReal& x) {
  return fabs(x);
}
WideReal undefined_if_infinite(const WideReal&) {
  return 0;
}

using hodt::degrees;
/// 0 degrees if both planes are the same.
WideReal degrees(const WideReal& sine, const WideReal& cosine) {
  if (sine == 0) return cosine > 0 ? 0 : 180;
  const WideReal cotangent = cosine / sine;
  // A smaller angle is its sine, rounded.
  if (cotangent > 0x1p60) return 180 / std::numbers::pi / cotangent;
  return degrees_of_rank(-cotangent.to_double());
}

using Gradient = EdgeValues::Gradient;

/// The same for numbers of any size.
struct WideGradient {
  WideReal x, y;
};

/// Between the normals (-f, 1) and (-g, 1): their cross product is (g.y - f.y, f.x - g.x, f x g).
constexpr auto angle_of_normals = [](auto, auto, const auto& f, const auto& g) HODT_INLINE_LAMBDA {
  const auto cross = f.x * g.y - f.y * g.x, u = g.y - f.y, v = f.x - g.x;
  const auto sine = sqrt_of(u * u + v * v + cross * cross);
  // If the sine is infinite the angle is undefined, and not a right one.
  return degrees(sine, f.x * g.x + f.y * g.y + 1) + undefined_if_infinite(sine);
};
constexpr auto weighted_angle =
    [](auto x, auto y, const auto& f, const auto& g)
        HODT_INLINE_LAMBDA { return sqrt_of(x * x + y * y) * angle_of_normals(x, y, f, g); };
constexpr auto jump = [](auto x, auto y, const auto& f, const auto& g) HODT_INLINE_LAMBDA {
  return size_of((f.x - g.x) * y - (f.y - g.y) * x) / sqrt_of(x * x + y * y);
};

/// Calls f with the function of a built-in measure.
template <class F>
void with_measure(EdgeMeasure measure, const F& f) {
  switch (measure.kind) {
    case EdgeMeasure::abn:
      return f(angle_of_normals);
    case EdgeMeasure::wabn:
      return f(weighted_angle);
    case EdgeMeasure::jnd:
      return f(jump);
    case EdgeMeasure::own:
      break;  // one by one
  }
}

}  // namespace

EdgeValues::EdgeValues(const Objective& objective, std::span<const Point> xy,
                       std::span<const double> z)
    : Aggregator(objective),
      measure_(std::get<EdgeMeasure>(objective.measure)),
      is_wide_(!is_own() && !(is_plain(xy) && is_plain(z))),
      xy_(xy),
      z_(z) {}

EdgeValues::Gradient EdgeValues::gradient(VertexId u, VertexId v, VertexId w) const {
  if (is_own()) return Gradient::of_corners(u, v, w);
  // Sorted without branches.
  const Index a = std::min({u, v, w}), c = std::max({u, v, w}), b = u ^ v ^ w ^ a ^ c;
  const double bx = xy_[b].x - xy_[a].x, by = xy_[b].y - xy_[a].y, bz = z_[b] - z_[a];
  const double cx = xy_[c].x - xy_[a].x, cy = xy_[c].y - xy_[a].y, cz = z_[c] - z_[a];
  const double area = bx * cy - by * cx;
  // Where rounding leaves no area, the exact one is not 0.
  if (area == 0 || is_wide_) return exact_gradient(a, b, c);
  return {(bz * cy - by * cz) / area, (bx * cz - bz * cx) / area};
}

EdgeValues::Gradient EdgeValues::exact_gradient(Index a, Index b, Index c) const {
  const auto of = [&](const auto& project) {
    return exact_cross(project(a), project(b), project(c));
  };
  const WideReal area = of([&](Index v) { return xy_[v]; });
  const WideReal x = of([&](Index v) { return Point{z_[v], xy_[v].y}; }) / area;
  const WideReal y = of([&](Index v) { return Point{xy_[v].x, z_[v]}; }) / area;
  for (const WideReal& g : {x, y})
    if (!g.is_in_range()) throw_out_of_range(objective(), g.is_large(), {xy_[a], xy_[b], xy_[c]});
  return {x.to_double(), y.to_double()};
}

Buffer<EdgeValues::Gradient> EdgeValues::gradients(const TriangleMesh& mesh) const {
  Buffer<Gradient> all(mesh.triangle_count());
  parallel_for(0, all.size(), 1 << 14, [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) {
      const auto [a, b, c] = mesh.corners(TriangleId(Index(t)));
      all[t] = gradient(a, b, c);
    }
  });
  return all;
}

double EdgeValues::across(VertexId a, VertexId b, const Gradient& f, const Gradient& g) const {
  if (is_own()) return own_value(a, b, f, g);
  if (is_wide_) return wide_value(a, b, f, g);
  double value = 0;
  const auto [x, y] = along(a, b);
  with_measure(measure_, [&, x = x, y = y](const auto& measure) { value = measure(x, y, f, g); });
  return is_finite(value) ? value : wide_value(a, b, f, g);
}

double EdgeValues::wide_value(VertexId a, VertexId b, const Gradient& f, const Gradient& g) const {
  const WideReal x = WideReal(xy_[b].x) - xy_[a].x, y = WideReal(xy_[b].y) - xy_[a].y;
  WideReal value;
  with_measure(measure_, [&](const auto& measure) {
    value = measure(x, y, WideGradient{f.x, f.y}, WideGradient{g.x, g.y});
  });
  if (!value.is_in_range()) throw_out_of_range(objective(), value.is_large(), {xy_[a], xy_[b]});
  return value.to_double();
}

/// From the smaller end to the larger one, then those on the left and on the right of that.
std::array<VertexId, 4> EdgeValues::own_corners(VertexId a, VertexId b, const Gradient& f,
                                                const Gradient& g) const {
  const VertexId left = f.other_corner(a, b), right = g.other_corner(a, b);
  return b < a ? std::array{b, a, right, left} : std::array{a, b, left, right};
}

std::array<Corner, 4> EdgeValues::places(const std::array<VertexId, 4>& corners) const {
  const auto corner = [&](VertexId v) {
    return Corner{xy_[v].x, xy_[v].y, z_.empty() ? 0 : z_[v]};
  };
  const auto [a, b, left, right] = corners;
  return {corner(a), corner(b), corner(left), corner(right)};
}

double EdgeValues::checked(double value, const std::array<VertexId, 4>& corners) const {
  const auto [a, b, left, right] = corners;
  return checked_own_value(value, objective(), {xy_[a], xy_[b], xy_[left], xy_[right]});
}

double EdgeValues::own_value(VertexId a, VertexId b, const Gradient& f, const Gradient& g) const {
  const std::array<VertexId, 4> corners = own_corners(a, b, f, g);
  const auto [from, to, left, right] = places(corners);
  return checked(measure_.own_measure->of(from, to, left, right), corners);
}

const double* ManyEdges::measure(std::size_t size, int left, int right) {
  const GradientColumns &f = left_[left], &g = right_[right];
  Column& value = value_[left][right];
  if (values_.is_own() && values_.measure_.own_measure->of_many) {
    if (size > 0) ask(size, left, right);
    return value.data();
  }
  const bool is_one_by_one = values_.is_own() || values_.is_wide_;
  if (!is_one_by_one)
    with_measure(values_.measure_, [&](const auto& measure) {
      run_in_lanes([&]<Index>() HODT_INLINE_LAMBDA {
        for (std::size_t i = 0; i < size; ++i) value[i] = measure(x_[i], y_[i], f.at(i), g.at(i));
      });
    });
  if (is_one_by_one || !are_finite({value.data(), size}))
    for (std::size_t i = 0; i < size; ++i)
      if (is_one_by_one || !is_finite(value[i])) value[i] = one(i, left, right);
  return value.data();
}

/// A measure of one's own, about all at once.
void ManyEdges::ask(std::size_t size, int left, int right) {
  std::array<std::array<VertexId, 4>, kSize> corners;
  std::array<std::array<Corner, 4>, kSize> places;
  for (std::size_t i = 0; i < size; ++i) {
    corners[i] =
        values_.own_corners(ends_[i][0], ends_[i][1], left_[left].at(i), right_[right].at(i));
    places[i] = values_.places(corners[i]);
  }
  Column& value = value_[left][right];
  values_.measure_.own_measure->of_many(std::span(places).first(size),
                                        std::span(value).first(size));
  for (std::size_t i = 0; i < size; ++i) value[i] = values_.checked(value[i], corners[i]);
}

double EdgeValues::of(const TriangleMesh& mesh) const {
  const Buffer<Gradient> all = gradients(mesh);
  const auto add = [&](std::size_t first, std::size_t last, std::vector<Total>& parts) {
    ManyEdges many(*this);
    std::size_t size = 0;
    const auto measure = [&] {
      parts.back().add({many.measure(size, 0, 0), size});
      size = 0;
    };
    for (std::size_t i = first; i < last; ++i) {
      const HalfEdgeId h{Index(i)}, twin = mesh.twin(h);
      if (!twin.valid() || twin < h) continue;
      if (size == 0 && parts.empty()) parts.emplace_back(*this);
      many.set(size++, mesh.origin(h), mesh.target(h), all[TriangleMesh::triangle(h)],
               all[TriangleMesh::triangle(twin)]);
      if (size == ManyEdges::kSize) measure();
    }
    if (size > 0) measure();
  };
  const std::vector<Total> parts = parallel_collect<Total>(0, mesh.halfedge_count(), 1 << 15, add);
  Total total(*this);
  for (const Total& part : parts) total.add(part);
  return parts.empty() ? 0 : total.value();
}

}  // namespace hodt
