#include "hodt/base/printable.h"

#include <cstddef>
#include <cstdint>

#include <fmt/format.h>

namespace hodt {

namespace {

struct Character {
  std::uint32_t code = 0;
  std::size_t size = 0;  ///< in bytes; 0 if the bytes are no UTF-8
};

std::uint32_t byte(char c) {
  return static_cast<unsigned char>(c);
}

/// The first character of a text that is not empty.
Character first_of(std::string_view text) {
  const std::uint32_t lead = byte(text[0]);
  if (lead < 0x80) return {lead, 1};
  const std::size_t size = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < size) return {};
  std::uint32_t code = lead & (0x7Fu >> size);
  for (const char c : text.substr(1, size - 1)) {
    if ((byte(c) & 0xC0) != 0x80) return {};
    code = code << 6 | (byte(c) & 0x3F);
  }
  const bool is_longer_than_needed = (size == 3 && code < 0x800) || (size == 4 && code < 0x10000);
  const bool is_surrogate = 0xD800 <= code && code < 0xE000;
  if (is_longer_than_needed || is_surrogate || code > 0x10FFFF) return {};
  return {code, size};
}

bool only_shows_itself(std::uint32_t code) {
  const auto within = [code](std::uint32_t first, std::uint32_t last) {
    return first <= code && code <= last;
  };
  const bool is_control = code < 0x20 || within(0x7F, 0x9F);
  const bool breaks_or_turns =
      within(0x200E, 0x200F) || within(0x2028, 0x202E) || within(0x2066, 0x2069);
  return !is_control && !breaks_or_turns;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const Character character = first_of(text);
    const std::string_view bytes = text.substr(0, character.size > 0 ? character.size : 1);
    if (character.size > 0 && only_shows_itself(character.code)) {
      result += bytes;
    } else {
      for (const char c : bytes) result += fmt::format("\\x{:02x}", byte(c));
    }
    text.remove_prefix(bytes.size());
  }
  return result;
}

}  // namespace hodt
