#include "families.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace families {
namespace {

/// Draws points until n different ones are there, or too many draws brought nothing new.
Points draw_distinct(int n, const std::function<std::pair<double, double>()>& draw) {
  Points points;
  std::set<std::pair<double, double>> seen;
  for (int failures = 0; static_cast<int>(points.size()) < n && failures < 1000;) {
    const auto p = draw();
    if (seen.insert(p).second) {
      points.push_back(p);
    } else {
      ++failures;
    }
  }
  return points;
}

Points choose(Points from, int n, Random& random) {
  random.shuffle(from);
  if (static_cast<int>(from.size()) > n) from.resize(n);
  return from;
}

bool all_on_a_line(const Points& points) {
  // Only asked of small integers, where doubles are exact.
  for (std::size_t i = 2; i < points.size(); ++i) {
    const double ax = points[1].first - points[0].first, ay = points[1].second - points[0].second;
    const double bx = points[i].first - points[0].first, by = points[i].second - points[0].second;
    if (ax * by != ay * bx) return false;
  }
  return true;
}

Points integer_points_on_circle(int radius_squared) {
  Points points;
  const int reach = static_cast<int>(std::sqrt(radius_squared)) + 1;
  for (int x = -reach; x <= reach; ++x) {
    for (int y = -reach; y <= reach; ++y) {
      if (x * x + y * y == radius_squared) points.emplace_back(x, y);
    }
  }
  return points;
}

/// Zero stays: its neighbours are 10^-324, which is another family's business.
double move_by_ulps(double value, int ulps) {
  if (value == 0) return value;
  const double towards =
      ulps < 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
  for (int i = 0; i < std::abs(ulps); ++i) value = std::nextafter(value, towards);
  return value;
}

}  // namespace

std::uint64_t Random::bits() {  // splitmix64
  state_ += 0x9e3779b97f4a7c15u;
  std::uint64_t b = state_;
  b = (b ^ (b >> 30)) * 0xbf58476d1ce4e5b9u;
  b = (b ^ (b >> 27)) * 0x94d049bb133111ebu;
  return b ^ (b >> 31);
}

double Random::real() {
  return static_cast<double>(bits() >> 11) * 0x1p-53;
}

int Random::integer(int low, int high) {
  return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
}

// ---- General position -----------------------------------------------------------------------

Points random_square(int n, std::uint64_t seed) {
  Random random(seed);
  return draw_distinct(n, [&] {
    const double x = random.real();
    return std::make_pair(x, random.real());
  });
}

Points clusters(int n, std::uint64_t seed) {
  Random random(seed);
  Points centres;
  for (int i = 0; i < 3; ++i) centres.emplace_back(random.real(-100, 100), random.real(-100, 100));
  return draw_distinct(n, [&] {
    const auto& [cx, cy] = centres[random.bits() % centres.size()];
    const double spread = random.integer(0, 1) ? 1e-3 : 1.0;
    const double x = cx + spread * random.real(-1, 1);
    return std::make_pair(x, cy + spread * random.real(-1, 1));
  });
}

Points convex_parabola(int n, std::uint64_t seed) {
  Random random(seed);
  Points points;
  for (int i = 0; i < n; ++i) points.emplace_back(i, i * i);
  random.shuffle(points);
  return points;
}

Points convex_ellipse(int n, std::uint64_t seed) {
  Random random(seed);
  return draw_distinct(n, [&] {
    const double angle = random.real(0, 2 * std::numbers::pi);
    return std::make_pair(3 * std::cos(angle), std::sin(angle));
  });
}

Points star(int n, std::uint64_t seed) {
  Random random(seed);
  Points points{{0.0, 0.0}};
  for (int i = 0; i + 1 < n; ++i) {
    const double angle = 2 * std::numbers::pi * (i + random.real(0, 0.5)) / (n - 1);
    points.emplace_back(std::cos(angle), std::sin(angle));
  }
  random.shuffle(points);
  return points;
}

// ---- Exact ties -----------------------------------------------------------------------------

Points lattice(int columns, int rows) {
  Points points;
  for (int x = 0; x < columns; ++x) {
    for (int y = 0; y < rows; ++y) points.emplace_back(x, y);
  }
  return points;
}

Points lattice_subset(int n, std::uint64_t seed, int side) {
  Random random(seed);
  while (true) {
    Points points = choose(lattice(side, side), n, random);
    if (!all_on_a_line(points)) return points;
  }
}

Points ring(int n, std::uint64_t seed, int radius_squared, bool with_centre) {
  Random random(seed);
  Points points = choose(integer_points_on_circle(radius_squared), n - with_centre, random);
  if (with_centre) points.emplace_back(0, 0);
  random.shuffle(points);
  return points;
}

Points concentric_rings(int n, std::uint64_t seed) {
  Random random(seed);
  Points points;
  for (const int radius_squared : {25, 50, 100}) {
    const Points circle = integer_points_on_circle(radius_squared);
    points.insert(points.end(), circle.begin(), circle.end());
  }
  return choose(points, n, random);
}

Points collinear_inside(int n, std::uint64_t seed) {
  Random random(seed);
  const int a = random.integer(1, 3), b = random.integer(0, 3);  // the direction of the line
  Points points{{-9 * b + a, 9 * a + b}, {9 * b, -9 * a}};       // one on either side
  for (int i = 0; i + 2 < n; ++i) points.emplace_back(a * (i - 2), b * (i - 2));
  random.shuffle(points);
  return points;
}

Points collinear_on_hull(int n, std::uint64_t seed) {
  Random random(seed);
  Points points;
  const int on_line = std::max(2, 2 * n / 3);
  const bool upright = random.integer(0, 1);
  for (int i = 0; i < on_line; ++i) points.emplace_back(i, 0);
  const Points rest = draw_distinct(n - on_line, [&] {
    const double x = random.integer(0, on_line - 1);
    return std::make_pair(x, random.integer(1, n) + 0.0);
  });
  points.insert(points.end(), rest.begin(), rest.end());
  for (auto& [x, y] : points) {
    if (upright) std::swap(x, y);
  }
  random.shuffle(points);
  return points;
}

Points fan(int n, std::uint64_t seed) {
  Random random(seed);
  const int dx = random.integer(0, 2), dy = dx ? random.integer(-2, 2) : 1;
  Points points;
  for (int i = 0; i + 1 < n; ++i) points.emplace_back(i * dx, i * dy);
  points.emplace_back(-dy * 2 + dx, dx * 2 + dy);
  random.shuffle(points);
  return points;
}

Points outline(int n, std::uint64_t seed) {
  Random random(seed);
  const int side = std::max(2, n / 2);
  Points rest;
  for (int i = 1; i < side; ++i) {
    for (const int far : {0, side}) {
      rest.emplace_back(i, far);
      rest.emplace_back(far, i);
    }
  }
  Points points = choose(rest, n - 3, random);
  points.insert(points.end(), {{0.0, 0.0}, {side + 0.0, 0.0}, {side + 0.0, side + 0.0}});
  random.shuffle(points);
  return points;
}

Points two_lines(int n, std::uint64_t seed) {
  Random random(seed);
  const int shift = random.integer(0, 2);
  Points points;
  for (int i = 0; i < n; ++i) points.emplace_back(i / 2 + (i % 2) * shift, (i % 2) * 2);
  random.shuffle(points);
  return points;
}

Points hexagonal(int n, std::uint64_t seed) {
  Random random(seed);
  const int side = static_cast<int>(std::ceil(std::sqrt(n))) + 1;
  Points points;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) points.emplace_back(x + 0.5 * (y % 2), y * std::sqrt(0.75));
  }
  while (true) {
    Points chosen = choose(points, n, random);
    if (!all_on_a_line(chosen)) return chosen;
  }
}

// ---- Hard on arithmetic ---------------------------------------------------------------------

Points nearly_cocircular(int n, std::uint64_t seed) {
  Points points = ring(n, seed, 32045, seed % 3 == 0);
  Random random(seed + 1);
  for (auto& [x, y] : points) {
    x = move_by_ulps(x, random.integer(-2, 2));
    y = move_by_ulps(y, random.integer(-2, 2));
  }
  return points;
}

Points nearly_collinear(int n, std::uint64_t seed) {
  Random random(seed);
  Points points{{random.real(-1, 1), 5.0}, {random.real(0, 9), -5.0}};
  const Points line = draw_distinct(n - 2, [&] {
    const double x = random.integer(0, 3 * n) * 0.1;
    return std::make_pair(x, move_by_ulps(x / 3, random.integer(-1, 1)));
  });
  points.insert(points.end(), line.begin(), line.end());
  random.shuffle(points);
  return points;
}

Points noisy_lattice(int n, std::uint64_t seed) {
  const int side = static_cast<int>(std::ceil(std::sqrt(n))) + 1;
  Points points = lattice_subset(n, seed, side);
  Random random(seed + 1);
  for (auto& [x, y] : points) {
    if (random.integer(0, 2) == 0) x += random.real(-1e-15, 1e-15);
    if (random.integer(0, 2) == 0) y += random.real(-1e-15, 1e-15);
  }
  return points;
}

Points huge_offset(int n, std::uint64_t seed) {
  const int side = static_cast<int>(std::ceil(std::sqrt(n))) + 1;
  Points points = lattice_subset(n, seed, side);
  for (auto& [x, y] : points) {
    x = 1e7 + 1e-3 * x;
    y = 2e7 + 1e-3 * y;
  }
  return points;
}

Points tiny_gaps(int n, std::uint64_t seed) {
  Random random(seed);
  Points points{{0.1, 0.1}, {0.9, 0.2}, {0.3, 0.8}};
  const Points near = draw_distinct(n - 3, [&] {
    auto [x, y] = points[random.bits() % points.size()];
    // At least one ulp away, so never one of the three themselves.
    x = move_by_ulps(x, random.integer(1, 3));
    return std::make_pair(x, move_by_ulps(y, random.integer(-2, 2)));
  });
  points.insert(points.end(), near.begin(), near.end());
  random.shuffle(points);
  return points;
}

Points wide_range(int n, std::uint64_t seed) {
  Random random(seed);
  const auto draw = [&] {
    if (random.integer(0, 5) == 0) return 0.0;
    const double sign = random.integer(0, 1) ? 1 : -1;
    // Half of the coordinates are powers of ten: equal x or y, and exact right angles.
    const double leading = random.integer(0, 1) ? 1.0 : random.real(1, 10);
    return sign * leading * std::pow(10.0, 50 * random.integer(-6, 6));
  };
  Points points{{1.0, 0.0}, {0.0, 1.0}, {0.0, 0.0}};
  const Points rest = draw_distinct(n, [&] {
    const double x = draw();
    return std::make_pair(x, draw());
  });
  for (const auto& p : rest) {
    const bool known = std::find(points.begin(), points.end(), p) != points.end();
    if (!known && static_cast<int>(points.size()) < n) points.push_back(p);
  }
  random.shuffle(points);
  return points;
}

Points subnormal_lattice(int n, std::uint64_t seed) {
  const int side = static_cast<int>(std::ceil(std::sqrt(n))) + 1;
  Points points = lattice_subset(n, seed, side);
  for (auto& [x, y] : points) {
    x *= std::numeric_limits<double>::denorm_min();
    y *= std::numeric_limits<double>::denorm_min();
  }
  return points;
}

// ---- Heights --------------------------------------------------------------------------------

Heights random_heights(const Points& points, std::uint64_t seed) {
  Random random(seed);
  Heights z;
  for (std::size_t i = 0; i < points.size(); ++i) z.push_back(random.real(0, 100));
  return z;
}

Heights few_heights(const Points& points, std::uint64_t seed) {
  Random random(seed);
  Heights z;
  for (std::size_t i = 0; i < points.size(); ++i) z.push_back(random.integer(0, 2));
  return z;
}

Heights equal_heights(const Points& points, std::uint64_t seed) {
  return Heights(points.size(), static_cast<double>(seed % 7));
}

Heights sloped_plane(const Points& points, std::uint64_t seed) {
  Random random(seed);
  const int a = random.integer(-2, 2), b = random.integer(-2, 2);
  Heights z;
  for (const auto& [x, y] : points) z.push_back(a * x + b * y);
  return z;
}

Heights permutation_heights(const Points& points, std::uint64_t seed) {
  Random random(seed);
  Heights z;
  for (std::size_t i = 0; i < points.size(); ++i) z.push_back(static_cast<double>(i));
  random.shuffle(z);
  return z;
}

// ---- Lists ----------------------------------------------------------------------------------

const std::vector<Family>& all() {
  const auto subset = [](int side) {
    return [side](int n, std::uint64_t seed) { return lattice_subset(n, seed, side); };
  };
  const auto on_ring = [](int radius_squared, bool with_centre) {
    return [=](int n, std::uint64_t seed) { return ring(n, seed, radius_squared, with_centre); };
  };
  static const std::vector<Family> families{
      {"random_square", random_square},
      {"clusters", clusters},
      {"convex_parabola", convex_parabola},
      {"convex_ellipse", convex_ellipse},
      {"star", star},
      {"lattice_4x4_subset", subset(4)},
      {"lattice_5x5_subset", subset(5)},
      {"lattice_8x8_subset", subset(8)},
      {"ring_25", on_ring(25, false)},
      {"ring_1105", on_ring(1105, false)},
      {"ring_1105_with_centre", on_ring(1105, true)},
      {"ring_32045", on_ring(32045, false)},
      {"concentric_rings", concentric_rings},
      {"collinear_inside", collinear_inside},
      {"collinear_on_hull", collinear_on_hull},
      {"fan", fan},
      {"outline", outline},
      {"two_lines", two_lines},
      {"hexagonal", hexagonal},
      {"nearly_cocircular", nearly_cocircular},
      {"nearly_collinear", nearly_collinear},
      {"noisy_lattice", noisy_lattice},
      {"huge_offset", huge_offset},
      {"tiny_gaps", tiny_gaps},
      {"wide_range", wide_range},
      {"subnormal_lattice", subnormal_lattice},
  };
  return families;
}

const std::vector<HeightFamily>& all_heights() {
  static const std::vector<HeightFamily> families{
      {"random", random_heights},
      {"few", few_heights},
      {"equal", equal_heights},
      {"plane", sloped_plane},
      {"permutation", permutation_heights},
  };
  return families;
}

}  // namespace families
