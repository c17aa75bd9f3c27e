// The two coordinates of a point side by side, so that one operation does both.
//
// A vector extension of gcc and clang: portable to any machine, SSE2 on x86. Comparisons yield
// masks: 0 or -1 a lane.
// Tested by tests/geometry/predicates_test.cpp.
#pragma once

#include "hodt/geometry/point.h"

namespace hodt::exact {

using Pair = double __attribute__((vector_size(16)));
using Mask = long long __attribute__((vector_size(16)));

inline Pair pair(const Point& p) {
  return Pair{p.x, p.y};
}
inline Point point(Pair v) {
  return {v[0], v[1]};
}
inline Pair both(double value) {
  return Pair{value, value};
}

/// The same bits, read as the other type.
inline Mask bits(Pair v) {
  return reinterpret_cast<Mask>(v);
}
inline Pair from_bits(Mask m) {
  return reinterpret_cast<Pair>(m);
}

inline Pair magnitude(Pair v) {
  return from_bits(bits(v) & 0x7fff'ffff'ffff'ffff);
}

/// p where the mask is set, else q. Spelled out, lest the compiler make a branch of it.
inline Pair choose(Mask mask, Pair p, Pair q) {
  return from_bits((mask & bits(p)) | (~mask & bits(q)));
}

inline Pair larger(Pair p, Pair q) {
  return choose(p < q, q, p);
}

inline Mask first(Mask mask) {
  return __builtin_shufflevector(mask, mask, 0, 0);
}
inline Mask second(Mask mask) {
  return __builtin_shufflevector(mask, mask, 1, 1);
}
inline bool all(Mask mask) {
  return (mask[0] & mask[1]) != 0;
}

}  // namespace hodt::exact
