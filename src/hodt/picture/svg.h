// An SVG document as it grows. Internal to this layer.
// Tested by tests/picture/picture_test.cpp.
#pragma once

#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "hodt/picture/markup.h"

namespace hodt {

/// The colour of text and frames.
inline constexpr std::string_view kInk = "#2b2a28";

class Svg {
 public:
  template <class... Args>
  void add(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
  }
  void text(double x, double y, double size, std::string_view content, std::string_view more = "") {
    add("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\"{}>{}</text>\n", x, y, size, more,
        escaped(content));
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

/// Breaks text at spaces into lines of at most `columns` letters; the end of a longer word is left
/// out.
std::vector<std::string> wrapped(std::string_view text, std::size_t columns);

}  // namespace hodt
