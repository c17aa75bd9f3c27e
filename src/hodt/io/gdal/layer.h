// A layer of map features, read feature by feature.
// Tested by tests/io/gdal_test.cpp.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/io/gdal/dataset.h"

namespace hodt {

class Layer {
 public:
  /// The layer of that name; if the name is empty, the only one with geometries. Throws what
  /// open_dataset() does; ParameterError, with the names there are, if there is no such layer.
  Layer(const std::filesystem::path& path, const std::string& name);

  std::string name() const;
  std::string crs() const;
  /// The format, as GDAL calls it.
  std::string driver() const;
  /// How many features there are, as far as the file says.
  std::size_t size() const;

  /// Number of a field of numbers. Throws ParameterError, with the fields there are, if there is
  /// none of the name.
  int number_field(const std::string& name) const;
  std::vector<std::string> fields() const;

  /// Calls f(feature, number) with each, numbered from 1; only the field (or none, -1) is read.
  /// Labels of drawings are left out; returns how many. InputErrors get the feature's number in
  /// front. Throws InputError, too, if the file is damaged.
  Index for_each(int field, const std::function<void(OGRFeatureH, Index)>& f) const;

 private:
  std::string file_;
  Dataset dataset_;
  OGRLayerH layer_ = nullptr;
};

/// Says how many labels for_each() left out; empty if none.
std::vector<std::string> label_warnings(Index labels);

}  // namespace hodt
