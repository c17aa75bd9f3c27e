// SVG drawn as pixels by librsvg, which is loaded when it is needed.
// Tested by tests/app/picture_test.cpp.
#pragma once

#include <string>

namespace hodt {

/// The bytes of a PNG file of a document of that size, in pixels; each becomes `scale` ones along
/// both axes. Throws ParameterError if the library is not there or cannot draw it.
std::string png_of_svg(const std::string& svg, double width, double height, double scale);

/// Throws ParameterError, saying how to get it, if the library cannot be loaded.
void require_svg_renderer();

}  // namespace hodt
