#include "hodt/base/utf8.h"

namespace hodt {

namespace {

char32_t byte(char c) {
  return static_cast<unsigned char>(c);
}

}  // namespace

Utf8Character first_character(std::string_view text) {
  const char32_t lead = byte(text[0]);
  if (lead < 0x80) return {lead, 1};
  const std::size_t size = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < size) return {};
  char32_t code = lead & (0x7Fu >> size);
  for (const char c : text.substr(1, size - 1)) {
    if ((byte(c) & 0xC0) != 0x80) return {};
    code = code << 6 | (byte(c) & 0x3F);
  }
  const bool is_longer_than_needed = (size == 3 && code < 0x800) || (size == 4 && code < 0x10000);
  const bool is_surrogate = 0xD800 <= code && code < 0xE000;
  if (is_longer_than_needed || is_surrogate || code > 0x10FFFF) return {};
  return {code, size};
}

}  // namespace hodt
