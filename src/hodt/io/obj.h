// Wavefront OBJ, as far as it says "mesh": v and f lines.
// Tested by tests/io/tin_file_test.cpp.
#pragma once

#include "hodt/io/atomic_write.h"
#include "hodt/io/input_text.h"
#include "hodt/tin/tin.h"

namespace hodt {

/// Reads v lines (x y or x y z; more numbers are colours or weights and are ignored) and f lines
/// (v, v/vt, v//vn or v/vt/vn; negative numbers count from the last vertex so far). A line
/// "# crs: EPSG:25832" is kept. All other lines are ignored. A backslash at the end of a v or f
/// line continues it on the next. Throws InputError, naming the line.
Tin parse_obj(const InputText& input);

void write_obj(const Tin& tin, OutputFile& file);

}  // namespace hodt
