#include "hodt/io/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include <fmt/compile.h>
#include <fmt/format.h>

namespace hodt {

char* format_number(char* to, double value) {
  return fmt::format_to(to, FMT_COMPILE("{}"), value);
}

char* format_number(char* to, std::uint32_t value) {
  return std::to_chars(to, to + kLongestNumber, value).ptr;
}

namespace number_text {

const char* read_exponent(const char* p, int& exponent) {
  const char* q = p + 1;
  const bool negative = *q == '-';
  if (*q == '-' || *q == '+') ++q;
  if (!is_digit(*q)) return p;
  int value = 0;
  // Far beyond any double, and far from overflow.
  for (; is_digit(*q); ++q) value = std::min(value * 10 + (*q - '0'), 100'000'000);
  exponent += negative ? -value : value;
  return q;
}

bool read_slowly(const char* start, const char* end, double& value) {
  const auto [stop, error] = std::from_chars(start, end, value);
  if (error == std::errc() && stop == end) return std::isfinite(value);
  if (error != std::errc::result_out_of_range) return false;
  // Out of range on either side: too small is zero to the nearest. The first digit that counts
  // decides which side it is.
  int leading = 0;
  bool counting = false;
  bool after_point = false;
  const char* p = start;
  for (; p != end && (is_digit(*p) || *p == '.'); ++p) {
    if (*p == '.') {
      after_point = true;
      continue;
    }
    counting = counting || *p != '0';
    if (counting && !after_point) leading = std::min(leading + 1, 100'000'000);
    if (!counting && after_point) leading = std::max(leading - 1, -100'000'000);
  }
  if (p != end) read_exponent(p, leading);
  value = 0;
  return leading < 0;
}

bool read_respelled(const char* start, const char* end, double& value) {
  std::string plain(start, end);
  for (char& c : plain) {
    if (c == ',') c = '.';
    if (c == 'd' || c == 'D') c = 'e';
  }
  return read_slowly(plain.data(), plain.data() + plain.size(), value);
}

}  // namespace number_text

}  // namespace hodt
