// Features written by GDAL, and what it knows to write of coordinate reference systems.
// Tested by tests/io/feature_file_test.cpp.
#pragma once

#include <string>

#include "hodt/io/atomic_write.h"
#include "hodt/io/feature_layer.h"

namespace hodt {

/// Each writes a layer as the file's only one. Throws FileError, and ParameterError if GDAL is not
/// there. A coordinate reference system that GDAL does not understand is written as the name of
/// one.
void write_flatgeobuf(const FeatureLayer& layer, OutputFile& file);
/// With the other files that belong to a shapefile.
void write_shapefile(const FeatureLayer& layer, OutputFile& file);

/// A system's well-known text (version 1); empty if GDAL is not there or does not know it.
std::string crs_definition(const std::string& crs);

}  // namespace hodt
