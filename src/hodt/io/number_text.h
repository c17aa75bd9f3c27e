// Numbers from text and to text, exactly and fast.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>

namespace hodt {

/// Longest text that format_number writes.
inline constexpr int kLongestNumber = 32;

/// Writes the shortest text that reads back as the same value; returns its end.
char* format_number(char* to, double value);
char* format_number(char* to, std::uint32_t value);

template <class Number>
void append_number(std::string& text, Number number) {
  char digits[kLongestNumber];
  text.append(digits, format_number(digits, number));
}

namespace number_text {

constexpr bool is_digit(char c) {
  return static_cast<unsigned char>(c - '0') < 10;
}

/// Whether the eight characters are all digits.
inline bool eight_digits(std::uint64_t characters) {
  constexpr std::uint64_t high = 0xF0F0F0F0F0F0F0F0, threes = 0x3030303030303030;
  return (characters & high) == threes && ((characters + 0x0606060606060606) & high) == threes;
}

/// The number that eight digits spell, first digit in the lowest byte: pairs, then fours, then all.
inline std::uint32_t value_of_eight(std::uint64_t characters) {
  characters -= 0x3030303030303030;
  characters = characters * 10 + (characters >> 8);
  constexpr std::uint64_t mask = 0x000000FF000000FF;
  constexpr std::uint64_t first = 100 + (std::uint64_t{1000000} << 32);
  constexpr std::uint64_t second = 1 + (std::uint64_t{10000} << 32);
  return static_cast<std::uint32_t>(
      (((characters & mask) * first) + (((characters >> 16) & mask) * second)) >> 32);
}

/// Appends the digits at p to the value, modulo 2^64; returns their end.
inline const char* read_digits(const char* p, std::uint64_t& value) {
  if constexpr (__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__) {
    std::uint64_t characters;
    for (std::memcpy(&characters, p, 8); eight_digits(characters); std::memcpy(&characters, p, 8)) {
      value = value * 100000000 + value_of_eight(characters);
      p += 8;
    }
  }
  for (; is_digit(*p); ++p) value = value * 10 + static_cast<std::uint64_t>(*p - '0');
  return p;
}

/// Reads the exponent after the letter at p; returns p itself if there is none.
const char* read_exponent(const char* p, int& exponent);

/// Whether an exponent may follow: after 'e', or 'd' in what Fortran writes.
constexpr bool is_exponent_letter(char c) {
  const char lower = static_cast<char>(c | 0x20);
  return lower == 'e' || lower == 'd';
}

/// Reads the unsigned number [start, end) by the standard library.
/// Returns false if it is too large for a double.
bool read_slowly(const char* start, const char* end, double& value);

/// The same for spellings that the standard library does not know: 1,5 and 1.5d3.
bool read_respelled(const char* start, const char* end, double& value);

inline constexpr double kPowersOfTen[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                          1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                          1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

}  // namespace number_text

/// Reads the decimal number at p, rounded to nearest; a number too small for a double is zero.
/// Returns the end of its text, or nullptr if there is no finite number here. `Decimal` stands
/// before the decimals.
/// Requires some character after it that is no part of a number, and eight readable bytes there.
template <char Decimal = '.'>
inline const char* parse_number(const char* p, double& value) {
  using namespace number_text;
  const bool negative = *p == '-';
  if (*p == '-' || *p == '+') ++p;
  const char* const start = p;
  std::uint64_t mantissa = 0;
  p = read_digits(p, mantissa);
  auto digits = p - start;
  int exponent = 0;
  if (*p == Decimal) {
    const char* const fraction = ++p;
    p = read_digits(p, mantissa);
    digits += p - fraction;
    exponent = static_cast<int>(fraction - p);
  }
  if (digits == 0) return nullptr;
  bool plain = Decimal == '.';
  if (is_exponent_letter(*p)) {
    plain = plain && (*p | 0x20) == 'e';
    p = read_exponent(p, exponent);
  }
  // Clinger's fast path: mantissa and power of ten are both exact doubles, so one rounding remains.
  if (digits <= 19 && mantissa <= (std::uint64_t{1} << 53) && -22 <= exponent && exponent <= 22) {
    const double whole = static_cast<double>(mantissa);
    value = exponent < 0 ? whole / kPowersOfTen[-exponent] : whole * kPowersOfTen[exponent];
  } else if (!(plain ? read_slowly : read_respelled)(start, p, value)) {
    return nullptr;
  }
  if (negative) value = -value;
  return p;
}

}  // namespace hodt
