// Geometries as well-known binary (ISO 13249-3), little-endian.
// Tested by tests/io/feature_file_test.cpp.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>

#include "hodt/io/feature_layer.h"

namespace hodt {

/// The bytes of a value as they lie in memory.
template <class T>
void append_raw(std::string& bytes, T value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof raw);
}

/// Of the features of one layer.
class WellKnownBinary {
 public:
  explicit WellKnownBinary(const FeatureLayer& layer);
  void append(std::string& bytes, const LayerFeature& feature) const;

 private:
  GeometryKind kind_;
  std::string head_;  ///< what all have in common
};

}  // namespace hodt
