#include "hodt/io/text_lines.h"

#include <algorithm>

#include <fmt/format.h>

namespace hodt {

std::size_t count_line_feeds(const char* p, const char* end) {
  std::size_t count = 0;
  // Byte-wide counters, so that the compiler can compare many bytes at once.
  constexpr std::ptrdiff_t width = 64;
  while (end - p >= width) {
    unsigned char counts[width] = {};
    for (int i = 0; i < 255 && end - p >= width; ++i, p += width) {
      for (int j = 0; j < width; ++j) counts[j] += p[j] == '\n';
    }
    for (const unsigned char c : counts) count += c;
  }
  return count + static_cast<std::size_t>(std::count(p, end, '\n'));
}

std::string place_of(std::string_view name, std::size_t line) {
  return fmt::format("{}, line {}", name, line);
}

std::string place_of(const InputText& input, const char* line) {
  return place_of(input.name, 1 + count_line_feeds(input.begin(), line));
}

}  // namespace hodt
