// Characters of UTF-8, one by one.
#pragma once

#include <cstddef>
#include <string_view>

namespace hodt {

struct Utf8Character {
  char32_t code = 0;
  std::size_t size = 0;  ///< in bytes; 0 if the bytes are no UTF-8
};

/// The first character of a text that is not empty. What is longer than it needs to be, a
/// surrogate or beyond U+10FFFF is no UTF-8.
Utf8Character first_character(std::string_view text);

/// Whether it is one of the C0 or C1 control characters, or delete.
constexpr bool is_control(char32_t code) {
  return code < 0x20 || (0x7F <= code && code < 0xA0);
}

}  // namespace hodt
