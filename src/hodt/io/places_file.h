// Places and areas on a map, from GeoJSON (RFC 7946) or a table of points.
#pragma once

#include <filesystem>
#include <string>

#include "hodt/geometry/places.h"
#include "hodt/io/input_text.h"

namespace hodt {

/// Reads the points and polygons of a file of features (formats.h), single, multiple or collected;
/// any other file, and "-", is a table that read_points() reads. Their parts are features (GeoJSON)
/// or points (a table), numbered from 1. `layer` is as for read_lines(). Throws FileError if the
/// file cannot be read, InputError if it cannot be used or holds anything else, such as lines.
Places read_places(const std::filesystem::path& path, const std::string& layer = {});

/// The same of GeoJSON in memory.
Places parse_places(const InputText& text);

}  // namespace hodt
