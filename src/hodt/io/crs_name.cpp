#include "hodt/io/crs_name.h"

#include <charconv>

#include <fmt/format.h>

namespace hodt {

namespace {

bool is_letter(char c) {
  return ('A' <= c && c <= 'Z') || ('a' <= c && c <= 'z');
}

std::optional<CrsCode> code_of(std::string_view authority, std::string_view digits) {
  long number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || end != digits.data() + digits.size() || number <= 0) return {};
  for (const char c : authority)
    if (!is_letter(c)) return {};
  if (authority.empty()) return {};
  return CrsCode{std::string(authority), number};
}

/// Takes `end` off the end of the text; false if it does not end so.
bool take_end(std::string_view& text, std::string_view end) {
  if (!text.ends_with(end)) return false;
  text.remove_suffix(end.size());
  return true;
}

/// What stands in the last brackets of well-known text, with the word before them.
std::optional<CrsCode> code_at_end(std::string_view text) {
  if (!take_end(text, "]]")) return {};
  const std::size_t open = text.rfind('[');
  if (open == std::string_view::npos) return {};
  const std::string_view before = text.substr(0, open);
  if (!before.ends_with("AUTHORITY") && !before.ends_with("ID")) return {};
  std::string_view inside = text.substr(open + 1);
  const std::size_t comma = inside.find(',');
  if (comma == std::string_view::npos) return {};
  const auto bare = [](std::string_view word) {
    while (!word.empty() && (word.front() == '"' || word.front() == ' ')) word.remove_prefix(1);
    while (!word.empty() && (word.back() == '"' || word.back() == ' ')) word.remove_suffix(1);
    return word;
  };
  return code_of(bare(inside.substr(0, comma)), bare(inside.substr(comma + 1)));
}

}  // namespace

bool is_wkt(std::string_view crs) {
  return crs.find('[') != std::string_view::npos;
}

std::optional<CrsCode> crs_code(std::string_view crs) {
  if (is_wkt(crs)) return code_at_end(crs);
  const std::size_t colon = crs.find(':');
  if (colon == std::string_view::npos) return {};
  return code_of(crs.substr(0, colon), crs.substr(colon + 1));
}

std::string crs_urn(const std::string& crs) {
  const std::optional<CrsCode> code = crs_code(crs);
  if (!code) return crs;
  constexpr long wgs84 = 4326;
  if (code->authority == "EPSG" && code->number == wgs84) return "urn:ogc:def:crs:OGC:1.3:CRS84";
  return fmt::format("urn:ogc:def:crs:{}::{}", code->authority, code->number);
}

}  // namespace hodt
