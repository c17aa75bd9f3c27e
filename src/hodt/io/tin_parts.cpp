#include "hodt/io/tin_parts.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "hodt/base/utf8.h"
#include "hodt/io/crs_name.h"

namespace hodt {

std::optional<std::int32_t> epsg_code(std::string_view crs) {
  const std::optional<CrsCode> code = crs_code(crs);
  if (!code || code->authority != "EPSG" || code->number > std::numeric_limits<std::int32_t>::max())
    return std::nullopt;
  return static_cast<std::int32_t>(code->number);
}

std::string in_one_line(std::string_view text) {
  std::string line;
  bool is_after_break = false;
  for (const char c : text) {
    const bool is_break = c == '\n' || c == '\r';
    if (!is_break && !(is_after_break && c == ' ')) line += c;
    is_after_break = is_break || (is_after_break && c == ' ');
  }
  return line;
}

std::string in_ascii(std::string_view text) {
  std::string ascii;
  while (!text.empty()) {
    const std::size_t size = std::max<std::size_t>(first_character(text).size, 1);
    ascii += static_cast<unsigned char>(text[0]) < 0x80 ? text[0] : '?';
    text.remove_prefix(size);
  }
  return ascii;
}

std::string xml_attribute(std::string_view text) {
  std::string escaped;
  while (!text.empty()) {
    const Utf8Character character = first_character(text);
    const std::string_view bytes = text.substr(0, std::max<std::size_t>(character.size, 1));
    text.remove_prefix(bytes.size());
    if (bytes.find_first_of("&<>\"\n") == 0) {
      escaped += fmt::format("&#{};", int{bytes[0]});
    } else if (character.size > 0 && !is_control(character.code) &&
               (character.code & 0xFFFE) != 0xFFFE) {
      escaped += bytes;
    }
  }
  return escaped;
}

}  // namespace hodt
