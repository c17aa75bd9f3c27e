#include "hodt/base/utf8.h"

#include <cstdint>
#include <string>

#include <gtest/gtest.h>

namespace hodt {
namespace {

/// By the table of the standard, which shares no arithmetic with the code.
std::string encoded(char32_t code) {
  std::string text;
  const auto add = [&](char32_t byte) { text.push_back(static_cast<char>(byte)); };
  if (code < 0x80) {
    add(code);
  } else if (code < 0x800) {
    add(0xC0 + code / 64);
    add(0x80 + code % 64);
  } else if (code < 0x10000) {
    add(0xE0 + code / 4096);
    add(0x80 + code / 64 % 64);
    add(0x80 + code % 64);
  } else {
    add(0xF0 + code / 262144);
    add(0x80 + code / 4096 % 64);
    add(0x80 + code / 64 % 64);
    add(0x80 + code % 64);
  }
  return text;
}

TEST(Utf8, every_character_is_read_and_none_cut_off) {
  for (char32_t code = 0; code <= 0x10FFFF; ++code) {
    const std::string text = encoded(code);
    const Utf8Character character = first_character(text + "x");
    if (0xD800 <= code && code < 0xE000) {
      ASSERT_EQ(character.size, 0u) << std::uint32_t{code};  // a surrogate
      continue;
    }
    ASSERT_EQ(std::uint32_t{character.code}, std::uint32_t{code});
    ASSERT_EQ(character.size, text.size()) << std::uint32_t{code};
    if (text.size() > 1) {
      ASSERT_EQ(first_character(text.substr(0, text.size() - 1)).size, 0u) << std::uint32_t{code};
    }
  }
}

TEST(Utf8, nothing_else_is_read) {
  for (const char* text :
       {"\x80", "\xBF", "\xC0\xAF", "\xC1\xBF", "\xE0\x80\xAF", "\xE0\x9F\xBF", "\xF0\x8F\xBF\xBF",
        "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF", "\xE2\x82(", "\xC3("})
    EXPECT_EQ(first_character(text).size, 0u) << text;
}

TEST(Utf8, knows_control_characters) {
  for (const char32_t code : {0x00, 0x1F, 0x7F, 0x80, 0x9F})
    EXPECT_TRUE(is_control(code)) << std::uint32_t{code};
  for (const char32_t code : {0x20, 0x7E, 0xA0, 0x2028})
    EXPECT_FALSE(is_control(code)) << std::uint32_t{code};
}

}  // namespace
}  // namespace hodt
