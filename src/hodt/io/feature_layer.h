// Features to write: points, lines or polygons with attributes, from which files of every vector
// format are made.
// Tested by tests/io/feature_file_test.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "hodt/geometry/point.h"

namespace hodt {

enum class FieldType : std::uint8_t { integer, real, text };

/// A column of the table of attributes.
struct Field {
  std::string name;
  FieldType type;
};

/// What a feature has in a field: of the field's type (text in UTF-8), or nothing (NULL). A real
/// value that is no finite number is nothing, too.
using FieldValue = std::variant<std::monostate, std::int64_t, double, std::string>;

enum class GeometryKind : std::uint8_t { point, line, polygon };

/// One feature. All coordinates are finite.
struct LayerFeature {
  /// One position of a point, two or more of a line, three or more of a polygon: its corners,
  /// counter-clockwise, the first one not repeated.
  std::vector<Point> xy;
  std::vector<double> z;           ///< of each position; empty in a layer without heights
  std::vector<FieldValue> values;  ///< of each field
};

struct FeatureLayer {
  std::string name = {};  ///< empty: that of the file, without its extension
  std::string crs = {};   ///< as in Tin
  GeometryKind geometry = GeometryKind::point;
  bool has_heights = true;
  std::vector<Field> fields = {};
  std::size_t count = 0;
  /// Fills in feature i, which holds an earlier one, of this layer; so assign, do not append. Is
  /// called by several threads at once.
  std::function<void(std::size_t i, LayerFeature& feature)> make = {};
};

}  // namespace hodt
