// Where the chunks of a LAZ file are.
// Tested by tests/io/las_damage_test.cpp.
#pragma once

#include <vector>

#include "hodt/io/las/chunk_decoder.h"
#include "hodt/io/las/las_header.h"
#include "hodt/io/las/laz_layout.h"

namespace hodt::las {

/// All chunks, of which each holds a point and the bytes of one at least; their points are as many
/// as the header says. Throws InputError if the table is missing or cannot be true.
std::vector<Chunk> read_chunk_table(const InputText& input, const LasHeader& header,
                                    const LazLayout& layout);

}  // namespace hodt::las
