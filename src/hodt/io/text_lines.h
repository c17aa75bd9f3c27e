// Walking over the lines of a text in memory, which ends in a line feed (see InputText).
// Tested by tests/io/point_file_test.cpp.
#pragma once

#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>

#include "hodt/io/input_text.h"

namespace hodt {

inline const char* next_line(const char* p, const char* end) {
  if (p >= end) return end;
  const void* feed = std::memchr(p, '\n', static_cast<std::size_t>(end - p));
  return feed ? static_cast<const char*>(feed) + 1 : end;
}

/// The line at p without its end.
inline std::string_view line_at(const char* p, const char* end) {
  std::string_view line(p, static_cast<std::size_t>(next_line(p, end) - p));
  while (line.ends_with('\n') || line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

inline const char* skip_blanks(const char* p) {
  while (*p == ' ' || *p == '\t') ++p;
  return p;
}

inline const char* skip_returns(const char* p) {
  while (*p == '\r') ++p;
  return p;
}

/// Whether a comment starts at p: none of these can start a value.
inline bool is_comment(const char* p) {
  return *p == '#' || *p == '%' || *p == '!' || *p == '>' || (*p == '/' && p[1] == '/');
}

/// Whether the line at p holds no data: blank, or a comment.
inline bool is_skipped(const char* p) {
  p = skip_returns(skip_blanks(p));
  return *p == '\n' || is_comment(p);
}

std::size_t count_line_feeds(const char* p, const char* end);

/// Where a line of a file is, for messages: "points.csv, line 3".
std::string place_of(std::string_view name, std::size_t line);
std::string place_of(const InputText& input, const char* line);

}  // namespace hodt
