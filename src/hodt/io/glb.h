// GLB: binary glTF 2.0, for viewers and the web.
// Tested by tests/io/tin_writers_test.cpp.
#pragma once

#include "hodt/io/atomic_write.h"
#include "hodt/tin/tin.h"

namespace hodt {

/// glTF has single precision and y up: x is east, y the height, z south, from an origin that the
/// node's translation adds (see local_frame.h). The node's extras name the origin in the mesh's own
/// axes, and the reference system. Throws InputError if the mesh is larger than the format can
/// hold.
void write_glb(const Tin& tin, OutputFile& file);

}  // namespace hodt
