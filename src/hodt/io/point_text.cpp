#include "hodt/io/point_text.h"

#include <cstddef>
#include <string>

#include "hodt/io/number_text.h"
#include "hodt/io/text_lines.h"

namespace hodt {

namespace {

bool is_letter(char c, char lower) {
  return (c | 0x20) == lower;
}

/// Steps over a word in any case; nullptr if another stands here.
const char* skip_word(const char* p, std::string_view lower) {
  for (const char c : lower) {
    if (!is_letter(*p++, c)) return nullptr;
  }
  return p;
}

/// PostGIS writes the reference system in front: "SRID=2056;".
const char* skip_reference(const char* p) {
  const char* q = skip_word(p, "srid");
  if (!q || *q != '=') return p;
  for (++q; number_text::is_digit(*q); ++q) {
  }
  return *q == ';' ? q + 1 : p;
}

}  // namespace

const char* parse_point_text(const char* p, double* values, bool& has_height) {
  p = skip_word(skip_reference(skip_blanks(p)), "point");
  if (!p) return nullptr;
  p = skip_blanks(p);
  const bool z = is_letter(*p, 'z');
  if (z) ++p;
  const bool m = is_letter(*p, 'm');
  if (m) ++p;
  p = skip_blanks(p);
  if (*p++ != '(') return nullptr;
  double numbers[4];
  std::size_t count = 0;
  for (p = skip_blanks(p); *p != ')'; p = skip_blanks(p)) {
    if (count == 4) return nullptr;
    p = parse_number(p, numbers[count++]);
    if (!p || (*p != ' ' && *p != '\t' && *p != ')')) return nullptr;
  }
  const std::size_t expected = 2 + (z ? 1 : 0) + (m ? 1 : 0);
  const bool bare_height = !z && !m && count == 3;
  if (count != expected && !bare_height) return nullptr;
  has_height = z || bare_height;
  values[0] = numbers[0];
  values[1] = numbers[1];
  if (has_height) values[2] = numbers[2];
  return skip_blanks(p + 1);
}

bool point_text_has_height(std::string_view text) {
  std::string padded(text);
  padded += '\n';
  padded.append(8, '\0');
  double values[3];
  bool has_height = false;
  return parse_point_text(padded.data(), values, has_height) && has_height;
}

}  // namespace hodt
