// Pixels inside a picture.
// Tested by tests/picture/picture_test.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace hodt {

struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  friend auto operator<=>(const Colour&, const Colour&) = default;
};

/// Rows from north to south, pixels as numbers of colours, 256 at most.
struct Image {
  std::size_t width = 0, height = 0;
  std::vector<Colour> colours;
  std::vector<std::uint8_t> pixels;
};

/// Makes the bytes of a PNG file of an image.
using ImagePacker = std::function<std::string(const Image&)>;

}  // namespace hodt
