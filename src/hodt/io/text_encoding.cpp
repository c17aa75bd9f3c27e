#include "hodt/io/text_encoding.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <utility>

#include "hodt/base/buffer.h"
#include "hodt/base/utf8.h"

namespace hodt {

namespace {

constexpr char32_t kReplacement = 0xFFFD;

void drop_front(InputText& input, std::size_t count) {
  input.size -= count;
  std::memmove(input.bytes.data(), input.bytes.data() + count, input.size);
}

constexpr bool is_high_surrogate(char32_t unit) {
  return 0xD800 <= unit && unit < 0xDC00;
}
constexpr bool is_low_surrogate(char32_t unit) {
  return 0xDC00 <= unit && unit < 0xE000;
}

/// The code units of UTF-16 in either byte order.
class Utf16 {
 public:
  Utf16(std::string_view bytes, bool little_endian)
      : bytes_(bytes), high_(little_endian ? 1 : 0), low_(little_endian ? 0 : 1) {}

  bool done() const { return at_ + 1 >= bytes_.size(); }
  char32_t take() {
    const char32_t unit = peek();
    at_ += 2;
    if (is_low_surrogate(unit)) return kReplacement;
    if (!is_high_surrogate(unit)) return unit;
    if (done() || !is_low_surrogate(peek())) return kReplacement;
    const char32_t low = peek();
    at_ += 2;
    return 0x10000 + ((unit - 0xD800) << 10) + (low - 0xDC00);
  }

 private:
  char32_t byte(std::size_t i) const { return static_cast<unsigned char>(bytes_[at_ + i]); }
  char32_t peek() const { return byte(high_) << 8 | byte(low_); }

  std::string_view bytes_;
  std::size_t high_, low_;
  std::size_t at_ = 0;
};

void decode_utf16(InputText& input, bool little_endian) {
  std::string text;
  text.reserve(input.size / 2);
  Utf16 units(input.view().substr(2), little_endian);
  while (!units.done()) append_utf8(text, units.take());
  input.bytes = Buffer<char>(text.size() + InputText::kPadding);
  input.size = text.size();
  std::memcpy(input.bytes.data(), text.data(), text.size());
}

}  // namespace

void decode(InputText& input) {
  const std::string_view text = input.view();
  constexpr std::string_view utf32 = std::string_view("\xFF\xFE\0\0", 4);
  if (text.starts_with("\xEF\xBB\xBF")) return drop_front(input, 3);
  if (text.starts_with(utf32)) return;  // refused as binary
  if (text.starts_with("\xFF\xFE")) return decode_utf16(input, true);
  if (text.starts_with("\xFE\xFF")) return decode_utf16(input, false);
}

void mend_line_ends(InputText& input) {
  char* const begin = input.bytes.data();
  char* const end = begin + input.size;
  char* p = std::find_if(begin, end, [](char c) { return c == '\n' || c == '\r'; });
  // Tools that convert line ends twice leave several carriage returns before a line feed.
  if (const char* const after = std::find_if(p, end, [](char c) { return c != '\r'; });
      p == end || after == p || (after != end && *after == '\n')) {
    return;
  }
  for (; p != end; ++p) {
    if (*p == '\r' && p[1] != '\n') *p = '\n';  // past the end is a line feed
  }
}

std::string readable(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const char32_t point = take_code_point(text);
    append_utf8(shown, is_control(point) ? U'?' : point);
  }
  return shown;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 24;
  std::string shown = "'";
  for (std::size_t i = 0; i < longest && !text.empty(); ++i) {
    const char32_t point = take_code_point(text);
    append_utf8(shown, is_control(point) ? U'?' : point);
  }
  return shown + (text.empty() ? "'" : "...'");
}

void append_utf8(std::string& text, char32_t point) {
  const auto add = [&](char32_t byte) { text.push_back(static_cast<char>(byte)); };
  const auto add_tail = [&](int shift) { add(0x80 | (point >> shift & 0x3F)); };
  if (point < 0x80) return add(point);
  if (point < 0x800) {
    add(0xC0 | point >> 6);
  } else if (point < 0x10000) {
    add(0xE0 | point >> 12);
    add_tail(6);
  } else {
    add(0xF0 | point >> 18);
    add_tail(12);
    add_tail(6);
  }
  add_tail(0);
}

char32_t take_code_point(std::string_view& text) {
  const Utf8Character character = first_character(text);
  const bool is_utf8 = character.size > 0;
  const char32_t point = is_utf8 ? character.code : static_cast<unsigned char>(text[0]);
  text.remove_prefix(is_utf8 ? character.size : 1);
  return point;
}

}  // namespace hodt
