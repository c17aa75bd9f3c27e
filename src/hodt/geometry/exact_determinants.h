// The two determinants, written once for every kind of integer.
//
// T has exact differences of coordinates; product() doubles its width (see wide_integer.h).
// Tested by tests/geometry/predicates_test.cpp.
#pragma once

#include "hodt/geometry/big_integer.h"
#include "hodt/geometry/wide_integer.h"

namespace hodt::exact {

template <class T>
struct Vector {
  T x, y;
};

template <class T>
auto cross(const Vector<T>& u, const Vector<T>& v) {
  return product(u.x, v.y) - product(u.y, v.x);
}

template <class T>
auto square(const Vector<T>& u) {
  return product(u.x, u.x) + product(u.y, u.y);
}

/// For a - c and b - c.
template <class T>
int orient_sign(const Vector<T>& a, const Vector<T>& b) {
  return sign_of(cross(a, b));
}

/// For a - d, b - d and c - d. If T is int64, these must be below 2^62. Then squares and cross
/// products are at most 2 * 2^124, and three products of them sum up to at most 12 * 2^248 < 2^252.
template <class T>
int in_circle_sign(const Vector<T>& a, const Vector<T>& b, const Vector<T>& c) {
  return sign_of(product(square(a), cross(b, c)) + product(square(b), cross(c, a)) +
                 product(square(c), cross(a, b)));
}

}  // namespace hodt::exact
