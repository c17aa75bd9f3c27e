#include "hodt/io/picture_file.h"

#include <cmath>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/file_name.h"
#include "hodt/io/svg_renderer.h"

namespace hodt {

namespace {

constexpr double kPixelsToUnit = 2;

}  // namespace

void write_picture(const Picture& picture, OutputFile& file) {
  check_picture_output(file.path());
  if (lower_extension(file.path()) == ".svg")
    file.write(picture.svg);
  else
    file.write(png_of_svg(picture.svg, picture.width, picture.height, kPixelsToUnit));
}

void check_picture_output(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  if (extension != ".svg" && extension != ".png")
    throw ParameterError(
        fmt::format("cannot write a picture to {}: known are .svg, .png", output_name(path)));
  if (extension == ".png") require_svg_renderer();
}

}  // namespace hodt
