// Files of points: every format that hodt reads or writes comes together here.
#pragma once

#include <filesystem>

#include "hodt/geometry/point_set.h"
#include "hodt/io/point_table.h"

namespace hodt {

/// Reads points, in the order of their rows; "-" is standard input. Reads text tables (see
/// docs/points.md) and LAS and LAZ, also packed with gzip. Every coordinate is finite and points.z
/// is either as long as points.xy or empty. Throws FileError if the file cannot be read, InputError
/// if it cannot be used, ParameterError if a chosen column is not there or a choice is for another
/// kind of file.
PointTable read_point_table(const std::filesystem::path& path, const PointChoice& choice = {});

/// The same without the columns that were taken and without warnings.
PointSet read_points(const std::filesystem::path& path, const PointChoice& choice = {});

/// Writes points so that read_points() gives them back bit for bit: .csv with the header x,y,z,
/// .xyz without, each also with .gz; "-" is CSV to standard output. The file appears complete or
/// not at all. Throws FileError, or ParameterError for any other extension.
void write_points(const PointSet& points, const std::filesystem::path& path);

/// Throws ParameterError, naming the known ones, unless write_points() knows the extension.
void check_points_extension(const std::filesystem::path& path);

}  // namespace hodt
