// What GDAL takes as it comes in an ESRI ASCII grid: how many values there are, and whether each is
// a number. It would read 0 for one that is none, and shift all that follow where one is missing.
// Tested by tests/io/gdal_test.cpp.
#pragma once

#include "hodt/io/input_text.h"

namespace hodt {

/// Throws InputError, naming the line, unless exactly ncols x nrows numbers (or NaN) follow the
/// header, on as many lines as you like; of nrows lines each has to be a row. Does nothing if the
/// header does not say how many there are.
void check_esri_grid(const InputText& input);

}  // namespace hodt
