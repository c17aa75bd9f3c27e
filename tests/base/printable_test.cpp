#include "hodt/base/printable.h"

#include <string>

#include <gtest/gtest.h>

namespace hodt {
namespace {

using namespace std::string_literals;

TEST(Printable, KeepsTextAsItIs) {
  for (const std::string text : {"", "terrain.csv", "a b~!\\", "H\u00f6he", "\u6c34", "\U0001f5fb"})
    EXPECT_EQ(printable(text), text);
}

TEST(Printable, WritesControlCharactersOut) {
  EXPECT_EQ(printable("a\nb\tc\r"), "a\\x0ab\\x09c\\x0d");
  EXPECT_EQ(printable("\0\x7f"s), "\\x00\\x7f");
  EXPECT_EQ(printable("\x1b[31mred"), "\\x1b[31mred");
  EXPECT_EQ(printable("\xc2\x9b\xc2\x9f\xc2\xa0"), "\\xc2\\x9b\\xc2\\x9f\xc2\xa0");
  // Text that runs backwards, and a line separator.
  EXPECT_EQ(printable("\u202evsc"), "\\xe2\\x80\\xaevsc");
  EXPECT_EQ(printable("\u2028"), "\\xe2\\x80\\xa8");
}

TEST(Printable, WritesBytesOutThatAreNoUtf8) {
  EXPECT_EQ(printable("H\xf6he"), "H\\xf6he");
  EXPECT_EQ(printable("\xff"), "\\xff");
  EXPECT_EQ(printable("\xc3"), "\\xc3");                             // cut
  EXPECT_EQ(printable("\xc3z"), "\\xc3z");                           // no continuation
  EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf");                    // longer than needed
  EXPECT_EQ(printable("\xe0\x80\xaf"), "\\xe0\\x80\\xaf");           // likewise
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");           // half of a surrogate pair
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");  // beyond the last character
}

}  // namespace
}  // namespace hodt
