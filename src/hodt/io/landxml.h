// LandXML 1.2: surfaces for programs that design roads and sites.
// Tested by tests/io/tin_writers_test.cpp.
#pragma once

#include "hodt/io/atomic_write.h"
#include "hodt/tin/tin.h"

namespace hodt {

/// One surface; points as northing, easting, height, numbered from 1. LandXML wants a unit, and
/// gets the metre; and a date, which is always the same one, so that the same mesh is the same
/// bytes.
void write_landxml(const Tin& tin, OutputFile& file);

}  // namespace hodt
