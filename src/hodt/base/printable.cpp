#include "hodt/base/printable.h"

#include <fmt/format.h>

#include "hodt/base/utf8.h"

namespace hodt {

namespace {

bool only_shows_itself(char32_t code) {
  const auto within = [code](char32_t first, char32_t last) {
    return first <= code && code <= last;
  };
  const bool breaks_or_turns =
      within(0x200E, 0x200F) || within(0x2028, 0x202E) || within(0x2066, 0x2069);
  return !is_control(code) && !breaks_or_turns;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const Utf8Character character = first_character(text);
    const std::string_view bytes = text.substr(0, character.size > 0 ? character.size : 1);
    if (character.size > 0 && only_shows_itself(character.code)) {
      result += bytes;
    } else {
      for (const char c : bytes) result += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    }
    text.remove_prefix(bytes.size());
  }
  return result;
}

}  // namespace hodt
