// Integers of 128 and 256 bits, and products that double the width of their factors.
// Tested by tests/geometry/integers_test.cpp.
#pragma once

#include <cstdint>

namespace hodt::exact {

__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 UInt128;

/// Two's complement: high * 2^128 + low.
struct Int256 {
  Int128 high;
  UInt128 low;
};

inline Int256 operator+(const Int256& a, const Int256& b) {
  const UInt128 low = a.low + b.low;
  return {a.high + b.high + (low < a.low ? 1 : 0), low};
}

inline std::int64_t product(std::int32_t a, std::int32_t b) {
  return std::int64_t{a} * b;
}
inline Int128 product(std::int64_t a, std::int64_t b) {
  return Int128{a} * b;
}

/// REQUIRES |a|, |b| <= 2^125. No branches: signs are as good as random here.
inline Int256 product(Int128 a, Int128 b) {
  const auto a0 = static_cast<std::uint64_t>(a), b0 = static_cast<std::uint64_t>(b);
  const auto a1 = static_cast<std::int64_t>(a >> 64), b1 = static_cast<std::int64_t>(b >> 64);
  const UInt128 bottom = UInt128{a0} * b0;
  const Int128 middle = Int128{a0} * b1 + Int128{b0} * a1 + static_cast<Int128>(bottom >> 64);
  return {Int128{a1} * b1 + (middle >> 64),
          static_cast<UInt128>(middle) << 64 | static_cast<std::uint64_t>(bottom)};
}

inline int sign_of(Int128 a) {
  return (a > 0) - (a < 0);
}
inline int sign_of(const Int256& a) {
  return a.high < 0 ? -1 : (a.high != 0 || a.low != 0);
}

}  // namespace hodt::exact
