// A point written as well-known text: POINT Z (600000 200000 451.5).
// Tested by tests/io/point_dialects_test.cpp.
#pragma once

#include <string_view>

namespace hodt {

/// Reads the point at p into values: x, y and, if it has one, z, and sets `has_height`. Returns the
/// end of its text, or nullptr if there is no such point here. Requires what parse_number() does.
const char* parse_point_text(const char* p, double* values, bool& has_height);

/// Whether the text is a point with a height.
bool point_text_has_height(std::string_view text);

}  // namespace hodt
