#include "hodt/io/feature_file.h"

#include "hodt/base/printable.h"
#include "hodt/io/formats.h"

namespace hodt {

void write_features(const FeatureLayer& layer, const std::filesystem::path& path) {
  const Format& format = format_for(path, Use::write_features);
  atomic_write(path, [&](OutputFile& file) { format.write_features(layer, file); });
}

void write_features(const FeatureLayer& layer, OutputFile& file) {
  format_for(file.path(), Use::write_features).write_features(layer, file);
}

void check_features_extension(const std::filesystem::path& path) {
  format_for(path, Use::write_features);
}

std::string layer_name(const FeatureLayer& layer, const std::filesystem::path& path) {
  return layer.name.empty() ? printable(path.stem().string()) : layer.name;
}

}  // namespace hodt
