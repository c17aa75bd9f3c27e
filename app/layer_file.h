// A file and one of its layers, as in roads.gpkg|layername=paved, which is how QGIS writes it.
// Tested by tests/app/inputs_test.cpp.
#pragma once

#include <string>
#include <string_view>

namespace hodt::app {

struct LayerFile {
  std::string file;
  std::string layer;  ///< empty if none is named
};

inline LayerFile layer_file(const std::string& text) {
  constexpr std::string_view mark = "|layername=";
  const std::size_t at = text.find(mark);
  if (at == text.npos) return {text, {}};
  return {text.substr(0, at), text.substr(at + mark.size())};
}

}  // namespace hodt::app
