// Files of features, in every vector format that hodt writes.
#pragma once

#include <filesystem>
#include <string>

#include "hodt/io/atomic_write.h"
#include "hodt/io/feature_layer.h"

namespace hodt {

/// Writes a layer in the format that the file's name tells; coordinates keep every bit. The file
/// appears complete or not at all. Throws FileError, or ParameterError for another extension.
void write_features(const FeatureLayer& layer, const std::filesystem::path& path);

/// The same to a file that is open.
void write_features(const FeatureLayer& layer, OutputFile& file);

/// Throws ParameterError, naming the known ones, unless write_features() knows the extension.
void check_features_extension(const std::filesystem::path& path);

/// The layer's name; without one that of the file, without its extension, made printable.
std::string layer_name(const FeatureLayer& layer, const std::filesystem::path& path);

}  // namespace hodt
