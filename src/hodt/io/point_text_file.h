// Writing points as text.
// Tested by tests/io/point_file_test.cpp.
#pragma once

#include "hodt/geometry/point_set.h"
#include "hodt/io/atomic_write.h"

namespace hodt {

/// Writes one line a point, so that reading gives the same bits back; packed with gzip if the
/// file's name says so. CSV has the header x,y,z (or x,y), XYZ has none and spaces in place of
/// commas.
void write_csv(const PointSet& points, OutputFile& file);
void write_xyz(const PointSet& points, OutputFile& file);

}  // namespace hodt
