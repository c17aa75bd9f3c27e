// VTU: unstructured grids of VTK, for ParaView and its like.
// Tested by tests/io/tin_writers_test.cpp.
#pragma once

#include "hodt/io/atomic_write.h"
#include "hodt/tin/tin.h"

namespace hodt {

/// Raw numbers after the XML. Points have z also as data, triangles their order and whether they
/// are none of the Delaunay triangulation, where that is known. The reference system is the bytes
/// of the field "crs": not every reader takes a field of text.
void write_vtu(const Tin& tin, OutputFile& file);

}  // namespace hodt
