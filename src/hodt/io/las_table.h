// LAS and LAZ as a file of points among others.
// Tested by tests/app/las_command_test.cpp.
#pragma once

#include "hodt/io/input_text.h"
#include "hodt/io/point_table.h"

namespace hodt {

/// Throws InputError if the file cannot be used, ParameterError if columns were chosen.
PointTable read_las_table(const InputText& input, const PointChoice& choice);

}  // namespace hodt
