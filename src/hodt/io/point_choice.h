// What the user says of a file of points: how it is to be read.
// Tested by tests/io/point_choice_test.cpp.
#pragma once

#include <optional>
#include <string>

#include "hodt/base/ids.h"
#include "hodt/io/column_choice.h"
#include "hodt/io/las/las_choice.h"

namespace hodt {

/// Of files of map features: which are points, and where their heights are.
struct LayerChoice {
  std::string layer = {};    ///< its name; empty: the only one
  std::string z_field = {};  ///< the field of heights; empty: those of the geometry
  bool no_z = false;         ///< without heights
  bool vertices = false;     ///< vertices of lines and polygons are points, too

  bool empty() const { return layer.empty() && z_field.empty() && !no_z && !vertices; }
};

/// Of rasters: which cells are points.
struct RasterChoice {
  Index band = 0;    ///< counted from 1; 0: the first
  Index stride = 0;  ///< every so many rows and columns; 0: all

  bool empty() const { return band == 0 && stride == 0; }
};

struct PointChoice {
  ColumnChoice columns = {};  ///< of tables
  LayerChoice layer = {};
  RasterChoice raster = {};
  std::optional<LasChoice> las = {};  ///< of LAS and LAZ
};

enum class PointKind { table, features, raster, las };

/// Throws ParameterError if something is chosen that files of the kind do not have.
void check_choice(const PointChoice& choice, PointKind kind, const std::string& name);

}  // namespace hodt
