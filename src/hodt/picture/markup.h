// Text inside SVG and HTML.
// Tested by tests/picture/picture_test.cpp.
#pragma once

#include <string>
#include <string_view>

namespace hodt {

/// The text with what markup would take for its own written as entities, and made printable.
std::string escaped(std::string_view text);

}  // namespace hodt
