#include "hodt/io/number_text.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "hodt/base/ids.h"

namespace hodt {
namespace {

/// What parse_number makes of the text; NaN if it refuses or stops early.
template <char Decimal = '.'>
double parsed(const std::string& text) {
  std::string padded = text;
  padded += '\n';
  padded.append(8, '\0');
  double value = 0;
  const char* const end = parse_number<Decimal>(padded.c_str(), value);
  return end == padded.c_str() + text.size() ? value : std::nan("");
}

std::string formatted(double value) {
  char text[kLongestNumber];
  return {text, format_number(text, value)};
}

TEST(NumberText, ReadsWhatPeopleWrite) {
  EXPECT_EQ(parsed("0"), 0);
  EXPECT_EQ(parsed("+1.5"), 1.5);
  EXPECT_EQ(parsed("-.5"), -0.5);
  EXPECT_EQ(parsed("5."), 5);
  EXPECT_EQ(parsed("1e3"), 1000);
  EXPECT_EQ(parsed("1E-03"), 0.001);
  EXPECT_EQ(parsed("0000000000000000000000000000012.25"), 12.25);
  EXPECT_EQ(parsed("12345678"), 12345678);
  EXPECT_EQ(parsed("123456789012345678"), 123456789012345678.0);
  EXPECT_EQ(parsed("9007199254740993"), 9007199254740992.0);
  EXPECT_TRUE(std::signbit(parsed("-0")));
}

TEST(NumberText, ReadsWhatFortranWrites) {
  EXPECT_EQ(parsed("0.0D0"), 0);
  EXPECT_EQ(parsed("1.5d+03"), 1500);
  EXPECT_EQ(parsed("-.25D-1"), -0.025);
  EXPECT_EQ(parsed("0.1234567890123456789D+01"), 1.2345678901234567);
  EXPECT_EQ(parsed("1D-999"), 0);
  for (const char* text : {"1d999", "d5", "1.0dx", "1e3d2"}) {
    EXPECT_TRUE(std::isnan(parsed(text))) << text;
  }
}

TEST(NumberText, ReadsDecimalCommas) {
  EXPECT_EQ(parsed<','>("2600000,25"), 2600000.25);
  EXPECT_EQ(parsed<','>("-,5"), -0.5);
  EXPECT_EQ(parsed<','>("7"), 7);
  EXPECT_EQ(parsed<','>("1,5e3"), 1500);
  EXPECT_EQ(parsed<','>("0,1234567890123456789"), 0.1234567890123456789);
  EXPECT_EQ(parsed<','>("0,0000000000000000000001e-400"), 0);
  for (const char* text : {"1.5", "1,234,567", "1,234.5", ","}) {
    EXPECT_TRUE(std::isnan(parsed<','>(text))) << text;
  }
}

TEST(NumberText, RefusesWhatIsNoFiniteNumber) {
  for (const char* text : {"", "-", ".", "+-1", "e5", "nan", "inf", "-inf", "1e999", "-1e400",
                           "1e99999999999999", "abc"}) {
    EXPECT_TRUE(std::isnan(parsed(text))) << text;
  }
}

TEST(NumberText, TooSmallIsZeroToTheNearest) {
  EXPECT_EQ(parsed("1e-999"), 0);
  EXPECT_EQ(parsed("0.0000000000000000000001e-400"), 0);
  EXPECT_EQ(parsed("4.9406564584124654e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(parsed("0e999"), 0);
}

TEST(NumberText, StopsAtTheEndOfTheNumber) {
  for (const char* text : {"1,", "1;", "1 ", "1e", "1e+,", "1x", "1.2.3"}) {
    EXPECT_TRUE(std::isnan(parsed(text))) << text;
  }
}

TEST(NumberText, AgreesWithStrtodOnDecimals) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 200000; ++i) {
    std::string text = std::to_string(random() >> (random() % 64));
    if (random() % 2) text.insert(random() % (text.size() + 1), ".");
    if (random() % 3 == 0)
      text.append("e").append(std::to_string(static_cast<int>(random() % 60) - 30));
    ASSERT_EQ(parsed(text), std::strtod(text.c_str(), nullptr)) << text;
  }
}

TEST(NumberText, RoundTripsEveryKindOfDouble) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 200000; ++i) {
    const double value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    const std::string text = formatted(value);
    ASSERT_LE(text.size(), std::size_t{kLongestNumber});
    ASSERT_EQ(std::bit_cast<std::uint64_t>(parsed(text)), std::bit_cast<std::uint64_t>(value))
        << text;
  }
}

TEST(NumberText, WritesTheShortest) {
  EXPECT_EQ(formatted(0.1), "0.1");
  EXPECT_EQ(formatted(300000), "300000");
  EXPECT_EQ(formatted(-2.5), "-2.5");
}

}  // namespace
}  // namespace hodt
