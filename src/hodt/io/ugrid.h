// UGRID: meshes in netCDF files, for hydraulic models, QGIS and xarray.
// Tested by tests/io/tin_writers_test.cpp.
#pragma once

#include "hodt/io/atomic_write.h"
#include "hodt/tin/tin.h"

namespace hodt {

/// Nodes with x, y and, if there are any, heights; faces with their nodes, counted from 0, and
/// where it is known their order and whether they are none of the Delaunay triangulation. The
/// reference system is a grid mapping, which has the attributes that readers of such files ask for.
/// Throws InputError if the mesh is larger than the format can hold.
void write_ugrid(const Tin& tin, OutputFile& file);

}  // namespace hodt
