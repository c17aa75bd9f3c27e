// GeoPackage (version 1.3 of the standard) to write: a database of SQLite.
// Tested by tests/io/feature_file_test.cpp.
#pragma once

#include "hodt/io/atomic_write.h"
#include "hodt/io/feature_layer.h"

namespace hodt {

/// Writes a layer as the file's only one, with a spatial index.
void write_geopackage(const FeatureLayer& layer, OutputFile& file);

}  // namespace hodt
