// What is no error, but nobody should miss.
// Tested by tests/app/formats_test.cpp.
#pragma once

#include <filesystem>
#include <string>

#include "hodt/tin/tin.h"

namespace hodt::app {

/// One line on standard error about a file.
void print_warning(const std::filesystem::path& file, const std::string& warning);

/// Says how far a written mesh is off, if its format holds numbers of single precision.
void warn_of_rounding(const std::filesystem::path& file, const Tin& tin);

}  // namespace hodt::app
