// Images as PNG.
// Tested by tests/io/png_test.cpp.
#pragma once

#include <string>

#include "hodt/picture/image.h"

namespace hodt {

/// The bytes of a PNG file. Requires 256 colours at most.
std::string png_of(const Image& image);

}  // namespace hodt
