// Mesh files: every format that hodt reads or writes comes together here.
#pragma once

#include <filesystem>

#include "hodt/io/atomic_write.h"
#include "hodt/tin/tin.h"

namespace hodt {

/// Reads a mesh: OBJ or PLY (text or binary), told by the extension, or by the first bytes where
/// there is none ("-" is standard input); also packed with gzip. Every coordinate is finite and
/// every corner a vertex. Throws FileError if the file cannot be read, InputError if it cannot be
/// used, ParameterError for an unknown extension.
Tin read_tin(const std::filesystem::path& path);

/// Writes a mesh: .obj, or .ply (binary, coordinates as doubles). Both formats want three
/// coordinates, so vertices without heights get z = 0. Reading gives the same bits back. The file
/// appears complete or not at all. Throws FileError, or ParameterError for any other extension.
void write_tin(const Tin& tin, const std::filesystem::path& path);

/// The same to a file that is open, in the format that its name tells.
void write_tin(const Tin& tin, OutputFile& file);

/// Throws ParameterError, naming the known ones, unless write_tin() knows the extension.
void check_output_extension(const std::filesystem::path& path);

}  // namespace hodt
