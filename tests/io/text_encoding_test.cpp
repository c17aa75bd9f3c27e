#include "hodt/io/text_encoding.h"

#include <string>
#include <string_view>

#include "temporary_directory.h"
#include <gtest/gtest.h>

namespace hodt {
namespace {

using std::string_view_literals::operator""sv;

/// The bytes of a file after reading it.
std::string read(std::string_view bytes) {
  const test::TemporaryDirectory directory;
  return std::string(read_input(directory.file("text", bytes)).view());
}

TEST(TextEncoding, utf16_with_a_mark_becomes_utf8) {
  EXPECT_EQ(read("\xFF\xFE\x31\0\xF6\0\xAC\x20"sv), "1\xC3\xB6\xE2\x82\xAC");
  EXPECT_EQ(read("\xFE\xFF\0\x31\0\xF6\x20\xAC"sv), "1\xC3\xB6\xE2\x82\xAC");
  // A pair of surrogates, halves of pairs, and half a unit.
  EXPECT_EQ(read("\xFF\xFE\x3D\xD8\x00\xDE"sv), "\xF0\x9F\x98\x80");
  EXPECT_EQ(read("\xFF\xFE\x3D\xD8\x31\0"sv), "\xEF\xBF\xBD\x31");
  EXPECT_EQ(read("\xFF\xFE\x00\xDE"sv), "\xEF\xBF\xBD");
  EXPECT_EQ(read("\xFF\xFE\x3D\xD8"sv), "\xEF\xBF\xBD");
  EXPECT_EQ(read("\xFF\xFE\x31\0\x32"sv), "1");
  EXPECT_EQ(read("\xFF\xFE"sv), "");
}

TEST(TextEncoding, marks_are_dropped_and_all_else_stays) {
  EXPECT_EQ(read("\xEF\xBB\xBFx"), "x");
  EXPECT_EQ(read("x\xEF\xBB\xBF\r\n\xFF"), "x\xEF\xBB\xBF\r\n\xFF");
  EXPECT_EQ(read("\xFF\xFE\0\0x\0\0\0"sv), "\xFF\xFE\0\0x\0\0\0"sv);  // UTF-32
}

TEST(TextEncoding, lone_carriage_returns_end_lines) {
  const auto mended = [](std::string_view bytes) {
    const test::TemporaryDirectory directory;
    InputText text = read_input(directory.file("text", bytes));
    mend_line_ends(text);
    return std::string(text.view());
  };
  EXPECT_EQ(mended("a\rb\rc"), "a\nb\nc");
  EXPECT_EQ(mended("a\rb\r"), "a\nb\r");  // what ends the input ends the line all the same
  EXPECT_EQ(mended("a\rb\r\nc\rd"), "a\nb\r\nc\nd");
  for (const char* text : {"", "a", "a\r", "a\r\nb\rc", "a\nb\rc", "a\r\r\nb", "\n"})
    EXPECT_EQ(mended(text), text);
}

TEST(TextEncoding, what_is_shown_is_utf8_without_control_characters) {
  EXPECT_EQ(readable("H\xC3\xB6he"), "H\xC3\xB6he");
  EXPECT_EQ(readable("H\xF6he"), "H\xC3\xB6he");
  EXPECT_EQ(readable("a\tb\x1B[1m\x7F"), "a?b?[1m?");
  EXPECT_EQ(readable("\xC2\x85"), "?");
  // Bytes that only look like UTF-8: cut short, too long a form, half a pair.
  EXPECT_EQ(readable("\xE2\x82"), "\xC3\xA2?");
  EXPECT_EQ(readable("\xC0\xAF"), "\xC3\x80\xC2\xAF");
  EXPECT_EQ(readable("\xE0\x80\xAF").substr(0, 2), "\xC3\xA0");
  EXPECT_EQ(readable("\xED\xA0\xBD").substr(0, 2), "\xC3\xAD");
  EXPECT_EQ(readable("\xF0\x9F\x98\x80"), "\xF0\x9F\x98\x80");
  EXPECT_EQ(in_quotes("abc"), "'abc'");
  EXPECT_EQ(in_quotes(std::string(24, 'a')), "'" + std::string(24, 'a') + "'");
  EXPECT_EQ(in_quotes(std::string(25, 'a')), "'" + std::string(24, 'a') + "...'");
}

}  // namespace
}  // namespace hodt
