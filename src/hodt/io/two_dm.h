// 2DM: the text meshes of SMS, which QGIS and hydraulic programs read.
// Tested by tests/io/tin_writers_test.cpp.
#pragma once

#include "hodt/io/atomic_write.h"
#include "hodt/tin/tin.h"

namespace hodt {

/// E3T and ND lines, numbered from 1.
void write_2dm(const Tin& tin, OutputFile& file);

}  // namespace hodt
