// What writers of meshes share.
// Tested by tests/io/tin_writers_test.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "hodt/tin/tin.h"

namespace hodt {

/// A vertex's height; 0 if there are none, for formats that want three coordinates.
inline double height_or_zero(const PointSet& points, std::size_t i) {
  return points.has_heights() ? points.z[i] : 0.0;
}

/// The number of "EPSG:25832", or that well-known text ends with; nothing for other systems.
std::optional<std::int32_t> epsg_code(std::string_view crs);

/// Without the line breaks, which WKT can do without, for comments of one line.
std::string in_one_line(std::string_view text);

/// With a question mark for each character that is not ASCII, for headers that hold nothing else.
std::string in_ascii(std::string_view text);

/// As the value of an attribute: what XML cannot hold is left out.
std::string xml_attribute(std::string_view text);

}  // namespace hodt
