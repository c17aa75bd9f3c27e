// Files of lines and outlines: every format that hodt reads them from comes together here.
#pragma once

#include <filesystem>
#include <string>

#include "hodt/geometry/lines.h"
#include "hodt/io/input_text.h"

namespace hodt {

/// Reads the lines of a file of features (formats.h, docs/lines.md), in its order:
/// LineStrings, and the rings of polygons, closed; at least one. Every coordinate is finite. Parts
/// are features. `layer` names the layer of a format that has them; empty: the only one. Throws
/// FileError if the file cannot be read, InputError, naming the feature, if it cannot be used or
/// holds points, ParameterError for any other extension.
Lines read_lines(const std::filesystem::path& path, const std::string& layer = {});

/// Reads the rings of polygons, and of lines that are closed; otherwise the same. An open line is
/// an error.
Outline read_outline(const std::filesystem::path& path, const std::string& layer = {});

/// The same of GeoJSON in memory.
Lines parse_lines(const InputText& text);
Outline parse_outline(const InputText& text);

}  // namespace hodt
