// What GDAL knows of coordinate reference systems.
// Tested by tests/io/crs_test.cpp.
#pragma once

#include <optional>
#include <string>

namespace hodt {

struct CrsFacts {
  std::string text;  ///< as hodt carries it: a code or WKT
  std::string name;
  bool is_geographic = false;
  bool is_plane = true;  ///< of x and y or of longitude and latitude, not geocentric or vertical
  double unit = 1;       ///< of x and y, in metres
  std::string unit_name;
  bool has_heights = false;
  double height_unit = 0;  ///< 0: it says nothing of it
  std::string height_unit_name;
};

/// Empty if there is no such system, and without GDAL.
std::optional<CrsFacts> crs_facts(const std::string& crs);

/// Whether they are the same, axes in whichever order; false also without GDAL.
bool are_equal_crs(const std::string& a, const std::string& b);

}  // namespace hodt
