// Unpacking and packing gzip.
// Tested by tests/io/point_file_test.cpp.
#pragma once

#include <string_view>

#include "hodt/io/input_text.h"

namespace hodt {

bool is_gzip(std::string_view bytes);

/// Unpacks all members, one after the other. The result has room for the padding.
/// Throws InputError if the data are damaged or cut short.
InputText gunzip(const InputText& packed);

/// Packs into one member, without a time stamp: the same bytes give the same file.
Buffer<char> gzip(std::string_view bytes);

}  // namespace hodt
