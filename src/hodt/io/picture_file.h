// Pictures as files: SVG, and PNG through librsvg.
//
// librsvg is loaded when the first PNG is drawn, so that nobody who has hodt needs it but for that.
// Tested by tests/app/picture_test.cpp.
#pragma once

#include <filesystem>

#include "hodt/io/atomic_write.h"
#include "hodt/picture/picture.h"

namespace hodt {

/// Writes a picture in the format that the file's name tells: .svg or .png. A PNG has two pixels
/// for each of the page's. Throws FileError, and ParameterError if librsvg cannot draw it.
void write_picture(const Picture& picture, OutputFile& file);

/// Throws ParameterError unless the name ends in .svg or .png, and if it is .png and librsvg is not
/// there.
void check_picture_output(const std::filesystem::path& path);

}  // namespace hodt
