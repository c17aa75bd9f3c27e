// What a file is that is no table of points.
// Tested by tests/io/point_dialects_test.cpp.
#pragma once

#include <string>
#include <string_view>

#include "hodt/io/input_text.h"

namespace hodt {

/// What the file is, and what to do with it: "a LAS point cloud; convert it to text". Empty if its
/// bytes look like no other format that holds points.
std::string foreign_format(std::string_view bytes);

/// Whether it begins as an ESRI ASCII grid does.
bool is_esri_grid(std::string_view bytes);

/// Throws InputError, saying what the input is, unless it can be a table of points.
void require_table(const InputText& input);

}  // namespace hodt
