// Integers wide enough for any in-circle determinant of doubles. Slow and simple: the last resort.
// Tested by tests/geometry/integers_test.cpp.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>

#include "hodt/geometry/wide_integer.h"

namespace hodt::exact {

/// Sign and magnitude, least significant word first, no leading zero words.
//
// Capacity: as a multiple of the smallest double, 2^-1074, a double has at most 2098 bits and a
// difference 2099: 33 words. An in-circle determinant is a sum of products of four differences:
// 8400 bits, and a product may need one word more before it is trimmed.
struct BigInteger {
  static constexpr int kCapacity = 136;
  bool negative = false;
  int size = 0;
  std::uint64_t word[kCapacity];

  void trim() {
    while (size > 0 && word[size - 1] == 0) --size;
  }
};

/// mantissa * 2^shift, with the sign given.
inline BigInteger shifted(std::uint64_t mantissa, int shift, bool negative) {
  BigInteger result;
  result.negative = negative;
  result.size = shift / 64 + 2;
  assert(result.size <= BigInteger::kCapacity);
  std::fill_n(result.word, result.size, 0);
  const UInt128 value = UInt128{mantissa} << (shift % 64);
  result.word[shift / 64] = static_cast<std::uint64_t>(value);
  result.word[shift / 64 + 1] = static_cast<std::uint64_t>(value >> 64);
  result.trim();
  return result;
}

inline bool magnitude_less(const BigInteger& a, const BigInteger& b) {
  if (a.size != b.size) return a.size < b.size;
  for (int i = a.size - 1; i >= 0; --i)
    if (a.word[i] != b.word[i]) return a.word[i] < b.word[i];
  return false;
}

/// |large| + |small|. Requires |large| >= |small|; so does magnitude_difference.
inline BigInteger magnitude_sum(const BigInteger& large, const BigInteger& small) {
  assert(large.size < BigInteger::kCapacity);
  BigInteger result;
  UInt128 carry = 0;
  for (int i = 0; i < large.size; ++i) {
    carry += large.word[i];
    if (i < small.size) carry += small.word[i];
    result.word[i] = static_cast<std::uint64_t>(carry);
    carry >>= 64;
  }
  result.word[large.size] = static_cast<std::uint64_t>(carry);
  result.size = large.size + 1;
  result.trim();
  return result;
}

inline BigInteger magnitude_difference(const BigInteger& large, const BigInteger& small) {
  BigInteger result;
  std::uint64_t borrow = 0;
  for (int i = 0; i < large.size; ++i) {
    const UInt128 subtrahend = UInt128{i < small.size ? small.word[i] : 0} + borrow;
    result.word[i] = large.word[i] - static_cast<std::uint64_t>(subtrahend);
    borrow = subtrahend > large.word[i];
  }
  result.size = large.size;
  result.trim();
  return result;
}

/// a + b, or a - b if flip.
inline BigInteger sum(const BigInteger& a, const BigInteger& b, bool flip) {
  const bool b_negative = b.negative != flip;
  const bool swap = magnitude_less(a, b);
  const BigInteger& large = swap ? b : a;
  const BigInteger& small = swap ? a : b;
  BigInteger result =
      a.negative == b_negative ? magnitude_sum(large, small) : magnitude_difference(large, small);
  result.negative = swap ? b_negative : a.negative;
  return result;
}

inline BigInteger operator+(const BigInteger& a, const BigInteger& b) {
  return sum(a, b, false);
}
inline BigInteger operator-(const BigInteger& a, const BigInteger& b) {
  return sum(a, b, true);
}

inline BigInteger product(const BigInteger& a, const BigInteger& b) {
  BigInteger result;
  result.negative = a.negative != b.negative;
  result.size = a.size + b.size;
  assert(result.size <= BigInteger::kCapacity);
  std::fill_n(result.word, result.size, 0);
  for (int i = 0; i < a.size; ++i) {
    UInt128 carry = 0;
    for (int j = 0; j < b.size; ++j) {
      carry += UInt128{a.word[i]} * b.word[j] + result.word[i + j];
      result.word[i + j] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    result.word[i + b.size] = static_cast<std::uint64_t>(carry);
  }
  result.trim();
  return result;
}

inline int sign_of(const BigInteger& a) {
  if (a.size == 0) return 0;
  return a.negative ? -1 : 1;
}

}  // namespace hodt::exact
