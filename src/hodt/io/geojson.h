// GeoJSON (RFC 7946) to write.
// Tested by tests/io/feature_file_test.cpp.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/geometry/point.h"
#include "hodt/io/atomic_write.h"
#include "hodt/io/feature_layer.h"

namespace hodt {

/// A polygon and the input rows that it belongs to.
struct PolygonFeature {
  std::vector<Point> ring;  ///< counter-clockwise, the first corner not repeated
  std::vector<Index> points;
};

/// Writes a FeatureCollection with a Polygon for each of the features 0 to count - 1, in this
/// order, with the property "points", and the coordinate reference system as write_geojson_layer()
/// names it. make(i, feature) fills in feature i, which holds an earlier one; it is called by
/// several threads at once. A feature with an empty ring is left out. Returns the number written.
std::size_t write_geojson(OutputFile& file, const std::string& crs, std::size_t count,
                          const std::function<void(std::size_t, PolygonFeature&)>& make);

/// Writes a layer, every feature on a line of its own. RFC 7946 knows no coordinate reference
/// system but longitude and latitude; any other is named by the member "crs", which the format had
/// before and most programs still read.
void write_geojson_layer(const FeatureLayer& layer, OutputFile& file);

}  // namespace hodt
