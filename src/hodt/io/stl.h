// STL, binary: triangles for printers and viewers.
// Tested by tests/io/tin_writers_test.cpp.
#pragma once

#include "hodt/io/atomic_write.h"
#include "hodt/tin/tin.h"

namespace hodt {

/// Coordinates are of single precision, from an origin that the header tells as text, as STL has no
/// other place for it (see local_frame.h). Throws InputError if there are more triangles or a
/// larger extent than the format can hold.
void write_stl(const Tin& tin, OutputFile& file);

}  // namespace hodt
