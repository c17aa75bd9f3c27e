// Integers of 128 and 256 bits, and products that double the width of their factors.
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

/// Requires |a|, |b| < 2^126.
inline Int256 product(Int128 a, Int128 b) {
  const UInt128 m = a < 0 ? -static_cast<UInt128>(a) : static_cast<UInt128>(a);
  const UInt128 n = b < 0 ? -static_cast<UInt128>(b) : static_cast<UInt128>(b);
  const std::uint64_t m0 = static_cast<std::uint64_t>(m), m1 = static_cast<std::uint64_t>(m >> 64);
  const std::uint64_t n0 = static_cast<std::uint64_t>(n), n1 = static_cast<std::uint64_t>(n >> 64);
  const UInt128 bottom = UInt128{m0} * n0;
  const UInt128 middle = UInt128{m0} * n1 + UInt128{m1} * n0 + (bottom >> 64);
  const UInt128 high = UInt128{m1} * n1 + (middle >> 64);
  const UInt128 low = middle << 64 | static_cast<std::uint64_t>(bottom);
  if ((a < 0) == (b < 0)) return {static_cast<Int128>(high), low};
  return {static_cast<Int128>(~high + (low == 0 ? 1 : 0)), -low};
}

inline int sign_of(Int128 a) {
  return (a > 0) - (a < 0);
}
inline int sign_of(const Int256& a) {
  if (a.high != 0) return sign_of(a.high);
  return a.low != 0;
}

}  // namespace hodt::exact
