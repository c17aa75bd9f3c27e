// Families of four points on which predicates go wrong, each aimed at one stage or one rounding.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>

#include "hodt/geometry/point.h"

namespace quads {

using hodt::Point;
using Quad = std::array<Point, 4>;

/// Random numbers that are the same everywhere (std distributions are not).
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  std::uint64_t bits() { return engine_(); }
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform in [low, high].
  int integer(int low, int high) {
    return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
  }
  double sign() { return integer(0, 1) == 0 ? 1 : -1; }

 private:
  std::mt19937_64 engine_;
};

inline void shuffle(Quad& q, Random& random) {
  for (int i = 3; i > 0; --i)
    std::swap(q[static_cast<std::size_t>(i)], q[static_cast<std::size_t>(random.integer(0, i))]);
}

/// Up to `most` units in the last place away.
inline double nudged(double value, Random& random, int most) {
  const double towards = random.sign() * std::numeric_limits<double>::infinity();
  for (int i = random.integer(0, most); i > 0; --i) value = std::nextafter(value, towards);
  return value;
}

/// Four points whose coordinates are made one by one.
template <class Coordinate>
Quad from_coordinates(Random& random, Coordinate coordinate) {
  Quad q;
  for (Point& p : q) {
    p.x = coordinate(random);
    p.y = coordinate(random);
  }
  return q;
}

inline Quad random_square(Random& random) {
  return from_coordinates(random, [](Random& r) { return r.uniform(); });
}

inline Quad nearly_collinear(Random& random) {
  const double slope = random.uniform(-2, 2), offset = random.uniform(-1, 1);
  Quad q;
  for (Point& p : q) {
    p.x = random.uniform(-10, 10);
    p.y = nudged(slope * p.x + offset, random, 2);
  }
  return q;
}

inline Quad nearly_cocircular(Random& random) {
  const Point centre = {random.uniform(-1, 1), random.uniform(-1, 1)};
  const double radius = random.uniform(0.1, 10);
  Quad q;
  for (Point& p : q) {
    const double angle = random.uniform(0, 6.283185307179586);
    p.x = nudged(centre.x + radius * std::cos(angle), random, 2);
    p.y = nudged(centre.y + radius * std::sin(angle), random, 2);
  }
  return q;
}

inline Quad small_lattice(Random& random) {
  return from_coordinates(random, [](Random& r) { return static_cast<double>(r.integer(-3, 3)); });
}

/// A millimetre lattice far from the origin, as UTM coordinates are.
inline Quad far_millimetres(Random& random) {
  return from_coordinates(random, [](Random& r) { return 1e7 + r.integer(0, 9) * 1e-3; });
}

/// The corners of a cell of a grid with decimal coordinates.
inline Quad decimal_rectangle(Random& random) {
  const double x0 = 412345.678, y0 = 5123456.789, step = 10.1;
  const int i = random.integer(0, 999), j = random.integer(0, 999);
  const double x[] = {x0 + i * step, x0 + (i + random.integer(1, 3)) * step};
  const double y[] = {y0 + j * step, y0 + (j + random.integer(1, 3)) * step};
  Quad q = {Point{x[0], y[0]}, {x[1], y[0]}, {x[0], y[1]}, {x[1], y[1]}};
  shuffle(q, random);
  return q;
}

/// Four of the twelve points at distance 5 from a point of a lattice of the given spacing and size.
inline Quad ring(Random& random, Point origin, double spacing, int size = 99) {
  static constexpr int kOffset[12][2] = {{5, 0},  {4, 3},   {3, 4},   {0, 5},  {-3, 4}, {-4, 3},
                                         {-5, 0}, {-4, -3}, {-3, -4}, {0, -5}, {3, -4}, {4, -3}};
  const int i = random.integer(0, size), j = random.integer(0, size);
  std::array<int, 12> order = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  Quad q;
  for (std::size_t k = 0; k < 4; ++k) {
    std::swap(order[k], order[static_cast<std::size_t>(random.integer(static_cast<int>(k), 11))]);
    q[k] = {origin.x + (i + kOffset[order[k]][0]) * spacing,
            origin.y + (j + kOffset[order[k]][1]) * spacing};
  }
  return q;
}

inline Quad integer_ring(Random& random) {
  return ring(random, {412345, 5123456}, 30);
}
/// Exact ties too wide for doubles: differences of some 40 bits.
inline Quad wide_ring(Random& random) {
  return ring(random, {412345.25, 5123456.25}, 16385 + 0x1p-10 + 0x1p-20);
}
/// The same, beyond the range of fixed width.
inline Quad huge_ring(Random& random) {
  return ring(random, {0, 0}, 0x1p100 + 0x1p70);
}

/// A ring of small lattice points, nudged: the sign hangs on the last bits.
inline Quad nudged_ring(Random& random) {
  Quad q = ring(random, {8, 8}, 1, 0);
  for (Point& p : q) p = {nudged(p.x, random, 1), nudged(p.y, random, 1)};
  return q;
}

/// Integers nearly on a circle, from small ones to those where doubles begin to round.
inline Quad integers_near_ring(Random& random) {
  const double spacing = std::floor(std::exp2(random.uniform(0, 16)));
  Quad q = ring(random, {0, 0}, spacing, 0);
  for (Point& p : q) p = {p.x + random.integer(-1, 1), p.y + random.integer(-1, 1)};
  return q;
}

/// Integers as nearly on a line as can be: consecutive Fibonacci vectors, whose cross product is 1.
inline Quad fibonacci(Random& random) {
  const Point origin = {1.0 * random.integer(-99, 99), 1.0 * random.integer(-99, 99)};
  const double sign = random.sign();
  Point step = {0, 1};
  for (int n = random.integer(0, 44); n > 0; --n) step = {step.y, step.x + step.y};
  Quad q;
  for (Point& p : q) {
    p = {origin.x + sign * step.x, origin.y + sign * step.y};
    step = {step.y, step.x + step.y};
  }
  q[static_cast<std::size_t>(random.integer(0, 3))] = origin;
  return q;
}

/// Nearly cocircular, of a size where terms overflow before they cancel.
inline Quad overflowing_circle(Random& random) {
  const double scale = std::ldexp(1, random.integer(250, 262));
  Quad q = nearly_cocircular(random);
  for (Point& p : q) p = {p.x * scale, p.y * scale};
  return q;
}

inline double any_magnitude(Random& random) {
  return random.sign() * std::ldexp(random.uniform(0.5, 1), random.integer(-996, 996));
}

/// Each coordinate of its own magnitude, 1e-300 to 1e300.
inline Quad any_magnitudes(Random& random) {
  return from_coordinates(random, any_magnitude);
}

/// All of one magnitude, any, with few bits: ties in units from 1e-300 to 1e300.
inline Quad scaled_lattice(Random& random) {
  const int exponent = random.integer(-1070, 1018);
  return from_coordinates(random, [&](Random& r) {
    return std::ldexp(static_cast<double>(r.integer(-3, 3)), exponent);
  });
}

/// Two points together at any distance, small or large, from the two others: the products of small
/// differences underflow, those of large ones overflow.
inline Quad two_scales(Random& random) {
  const double scale[] = {std::fabs(any_magnitude(random)), std::fabs(any_magnitude(random))};
  Quad q;
  for (std::size_t i = 0; i < 4; ++i)
    q[i] = {scale[i / 2] * random.integer(-3, 3), scale[i / 2] * random.integer(-3, 3)};
  shuffle(q, random);
  return q;
}

/// About where squares, or fourth powers, underflow.
inline Quad near_underflow(Random& random) {
  const int exponent = random.integer(0, 1) == 0 ? -270 : -540;
  return from_coordinates(random, [&](Random& r) {
    return std::ldexp(static_cast<double>(r.integer(-9, 9)), exponent + r.integer(-12, 12));
  });
}

/// About where squares, or fourth powers, overflow.
inline Quad near_overflow(Random& random) {
  const int exponent = random.integer(0, 1) == 0 ? 254 : 510;
  return from_coordinates(random, [&](Random& r) {
    return std::ldexp(static_cast<double>(r.integer(-9, 9)), exponent + r.integer(-3, 3));
  });
}

/// Denormals, and with them the smallest normal numbers.
inline Quad denormals(Random& random) {
  const double unit = random.integer(0, 1) == 0 ? DBL_TRUE_MIN : DBL_MIN / 2;
  return from_coordinates(
      random, [&](Random& r) { return r.integer(-4, 4) * unit + r.integer(-1, 1) * DBL_TRUE_MIN; });
}

inline double extreme(Random& random) {
  static constexpr double kValues[] = {0, DBL_TRUE_MIN, DBL_MIN,     1e-160, 1,
                                       3, 1e150,        DBL_MAX / 2, DBL_MAX};
  return random.sign() * kValues[random.integer(0, 8)];
}

inline Quad extremes(Random& random) {
  return from_coordinates(random, extreme);
}

/// Any bit pattern that is finite.
inline Quad any_bits(Random& random) {
  return from_coordinates(random, [](Random& r) {
    for (;;)
      if (const auto value = std::bit_cast<double>(r.bits()); std::isfinite(value)) return value;
  });
}

struct Family {
  const char* name;
  Quad (*make)(Random&);
};

inline constexpr Family kFamilies[] = {
    {"random_square", random_square},
    {"nearly_collinear", nearly_collinear},
    {"nearly_cocircular", nearly_cocircular},
    {"small_lattice", small_lattice},
    {"far_millimetres", far_millimetres},
    {"decimal_rectangle", decimal_rectangle},
    {"integer_ring", integer_ring},
    {"wide_ring", wide_ring},
    {"huge_ring", huge_ring},
    {"nudged_ring", nudged_ring},
    {"integers_near_ring", integers_near_ring},
    {"fibonacci", fibonacci},
    {"overflowing_circle", overflowing_circle},
    {"any_magnitudes", any_magnitudes},
    {"scaled_lattice", scaled_lattice},
    {"two_scales", two_scales},
    {"near_underflow", near_underflow},
    {"near_overflow", near_overflow},
    {"denormals", denormals},
    {"extremes", extremes},
    {"any_bits", any_bits},
};

/// A mixture: each point from a family of its own.
inline Quad mixture(Random& random) {
  Quad q;
  for (std::size_t i = 0; i < 4; ++i)
    q[i] = kFamilies[static_cast<std::size_t>(random.integer(0, std::size(kFamilies) - 1))].make(
        random)[i];
  return q;
}

}  // namespace quads
