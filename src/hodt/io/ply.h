// PLY (Stanford polygon files), text and binary.
// Tested by tests/io/tin_file_test.cpp.
#pragma once

#include "hodt/io/atomic_write.h"
#include "hodt/io/input_text.h"
#include "hodt/tin/tin.h"

namespace hodt {

/// Whether the input begins as PLY files do.
bool is_ply(const InputText& input);

/// Reads the vertices' x, y and, if there, z (also X, Y, Z), and the faces' vertex_indices (or
/// vertex_index), of any types; other properties and elements are skipped. In text each item starts
/// a line of its own. A "comment crs: EPSG:25832" is kept. What the header announces is not
/// believed: it costs no more time or memory than the file's size allows.
/// Throws InputError, naming the header's line or the vertex or face (counted from 0).
Tin parse_ply(const InputText& input);

/// Writes binary PLY, little-endian, coordinates as doubles.
void write_ply(const Tin& tin, OutputFile& file);

}  // namespace hodt
