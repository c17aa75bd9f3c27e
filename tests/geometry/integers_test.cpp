// The wide integers behind the predicates, against GMP, on words that make carries run.
#include <cstdint>
#include <vector>

#include "quads.h"
#include <gmpxx.h>
#include <gtest/gtest.h>

#include "hodt/geometry/big_integer.h"
#include "hodt/geometry/wide_integer.h"

namespace {

using hodt::exact::BigInteger;
using hodt::exact::Int128;
using hodt::exact::Int256;
using hodt::exact::product;
using hodt::exact::UInt128;
using quads::Random;

/// A word that is often all zeros, all ones or nearly so.
std::uint64_t word(Random& random) {
  switch (random.integer(0, 5)) {
    case 0:
      return 0;
    case 1:
      return ~std::uint64_t{0};
    case 2:
      return std::uint64_t{1} << random.integer(0, 63);
    default:
      return random.bits();
  }
}

mpz_class words(const std::uint64_t* data, std::size_t count) {
  mpz_class result;
  mpz_import(result.get_mpz_t(), count, -1, sizeof(std::uint64_t), 0, 0, data);
  return result;
}

mpz_class value(Int128 a) {
  const bool negative = a < 0;
  const UInt128 magnitude = negative ? -static_cast<UInt128>(a) : static_cast<UInt128>(a);
  const std::uint64_t data[] = {static_cast<std::uint64_t>(magnitude),
                                static_cast<std::uint64_t>(magnitude >> 64)};
  const mpz_class result = words(data, 2);
  return negative ? mpz_class(-result) : result;
}

mpz_class value(const Int256& a) {
  const std::uint64_t low[] = {static_cast<std::uint64_t>(a.low),
                               static_cast<std::uint64_t>(a.low >> 64)};
  return (value(a.high) << 128) + words(low, 2);
}

mpz_class value(const BigInteger& a) {
  const mpz_class result = words(a.word, static_cast<std::size_t>(a.size));
  return a.negative ? mpz_class(-result) : result;
}

/// At most 2^125 in magnitude, as product() requires.
Int128 random_int128(Random& random) {
  const UInt128 bits = UInt128{word(random)} << 64 | word(random);
  return static_cast<Int128>(bits) >> random.integer(2, 127);
}

BigInteger random_big(Random& random, int most_words) {
  BigInteger result;
  result.negative = random.integer(0, 1) == 1;
  result.size = random.integer(0, most_words);
  for (int i = 0; i < result.size; ++i) result.word[i] = word(random);
  result.trim();
  return result;
}

TEST(Int256, ProductsAndSums) {
  Random random(1);
  Int256 last = {0, 0};
  for (int i = 0; i < 100000; ++i) {
    const Int128 a = random_int128(random), b = random_int128(random);
    const Int256 ab = product(a, b);
    ASSERT_EQ(value(ab), value(a) * value(b));
    ASSERT_EQ(sign_of(ab), sgn(value(a)) * sgn(value(b)));
    ASSERT_EQ(value(ab + last), value(ab) + value(last));
    last = ab;
  }
}

TEST(Int256, LargestProducts) {
  const Int128 most = Int128{1} << 125;
  for (const Int128 a : {most, -most})
    for (const Int128 b : {most, -most, most - 1, 1 - most})
      EXPECT_EQ(value(product(a, b)), value(a) * value(b));
}

TEST(BigInteger, SumsDifferencesProducts) {
  Random random(2);
  for (int i = 0; i < 20000; ++i) {
    const BigInteger a = random_big(random, 60), b = random_big(random, 60);
    ASSERT_EQ(value(a + b), value(a) + value(b));
    ASSERT_EQ(value(a - b), value(a) - value(b));
    ASSERT_EQ(value(product(a, b)), value(a) * value(b));
    ASSERT_EQ(sign_of(a), sgn(value(a)));
    ASSERT_EQ(sign_of(a - a), 0);
    BigInteger close = a;
    if (close.size > 0) close.word[0] ^= 1;
    ASSERT_EQ(value(a - close), value(a) - value(close));
  }
}

TEST(BigInteger, Shifted) {
  for (const int shift : {0, 1, 11, 12, 63, 64, 65, 127, 128, 2045}) {
    const std::uint64_t mantissa = (std::uint64_t{1} << 53) - 1;
    EXPECT_EQ(value(hodt::exact::shifted(mantissa, shift, false)),
              words(&mantissa, 1) << static_cast<unsigned>(shift));
  }
  EXPECT_EQ(sign_of(hodt::exact::shifted(0, 100, true)), 0);
}

}  // namespace
