// Names of coordinate reference systems, as files write them.
// Tested by tests/io/feature_file_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace hodt {

/// Whether a system is told as well-known text, not by an authority's code.
bool is_wkt(std::string_view crs);

/// The number in a list of systems.
struct CrsCode {
  std::string authority;  ///< "EPSG"
  long number;
};

/// Of "EPSG:25832", or of well-known text that ends by saying so: AUTHORITY["EPSG","25832"]] or
/// ID["EPSG",25832]]. Nothing else is tried.
std::optional<CrsCode> crs_code(std::string_view crs);

/// "urn:ogc:def:crs:EPSG::25832"; longitude and latitude of WGS 84 are CRS84, which has them in
/// this order. A system that has no code stays as it is.
std::string crs_urn(const std::string& crs);

}  // namespace hodt
