// The predicates from their definitions, in GMP integers: determinants, expanded by the book.
// Shares nothing with hodt but the Point.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <gmpxx.h>

#include "hodt/geometry/point.h"

namespace exact_oracle {

using hodt::Point;
using Matrix = std::vector<std::vector<mpz_class>>;

/// value * 2^exponent, which must be an integer.
inline mpz_class integer(double value, int exponent = 1074) {
  int e = 0;
  const double mantissa = std::ldexp(std::frexp(value, &e), 53);
  mpz_class result(mantissa);
  const int shift = e - 53 + exponent;
  if (shift >= 0) return result << static_cast<unsigned>(shift);
  return result >> static_cast<unsigned>(-shift);
}

inline mpz_class determinant(const Matrix& m) {
  if (m.size() == 1) return m[0][0];
  mpz_class sum = 0;
  for (std::size_t row = 0; row < m.size(); ++row) {
    Matrix minor;
    for (std::size_t i = 0; i < m.size(); ++i)
      if (i != row) minor.emplace_back(m[i].begin() + 1, m[i].end());
    const mpz_class term = m[row][0] * determinant(minor);
    sum += row % 2 == 0 ? term : mpz_class(-term);
  }
  return sum;
}

inline int orient(const Point& a, const Point& b, const Point& c) {
  Matrix m;
  for (const Point& p : {a, b, c}) m.push_back({integer(p.x), integer(p.y), 1});
  return sgn(determinant(m));
}

/// | x y x²+y² 1 |, times 2^(4 * 1074): positive if d is inside the counter-clockwise abc.
inline mpz_class in_circle_determinant(const Point& a, const Point& b, const Point& c,
                                       const Point& d) {
  Matrix m;
  for (const Point& p : {a, b, c, d}) {
    const mpz_class x = integer(p.x), y = integer(p.y);
    m.push_back({x, y, mpz_class(x * x + y * y), 1});
  }
  return determinant(m);
}

inline int in_circle_plain(const Point& a, const Point& b, const Point& c, const Point& d) {
  return sgn(in_circle_determinant(a, b, c, d));
}

/// The perturbation taken at its word: lifts are raised by positive numbers, each smaller than the
/// next larger one (in lexicographic order) by a factor of 2^4400, more than any ratio of numbers
/// that can occur.
inline bool in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
  constexpr unsigned kStep = 4400;
  const std::array<Point, 4> points = {a, b, c, d};
  Matrix m;
  for (const Point& p : points) {
    unsigned larger = 0;
    for (const Point& q : points) larger += std::pair(q.x, q.y) > std::pair(p.x, p.y);
    const mpz_class x = integer(p.x), y = integer(p.y);
    const mpz_class lift =
        ((x * x + y * y) << (4 * kStep)) + (mpz_class(1) << ((3 - larger) * kStep));
    m.push_back({x, y, lift, 1});
  }
  return sgn(determinant(m)) > 0;
}

}  // namespace exact_oracle
