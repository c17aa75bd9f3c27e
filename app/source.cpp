#include "app/source.h"

#include <algorithm>
#include <string>
#include <utility>

#include "hodt/base/error.h"
#include "hodt/io/formats.h"
#include "hodt/io/input_text.h"
#include "hodt/io/tin_file.h"
#include "hodt/pipeline/given_tin.h"

namespace hodt::app {

Source read_source(const PointsInput& input) {
  const auto is_mesh = [](const std::string& file) {
    return find_format(file, Use::read_tin) != nullptr;
  };
  const auto mesh = std::find_if(input.files.begin(), input.files.end(), is_mesh);
  if (mesh == input.files.end()) return {false, read_input_points(input), {}, 0, {}};
  if (input.files.size() > 1)
    throw ParameterError(display_name(*mesh) + " is a mesh, which cannot be one of several files");
  if (input.chooses_points())
    throw ParameterError("--columns and other options that choose points are for points, and " +
                         display_name(*mesh) + " is a mesh");
  Tin tin = read_tin(*mesh);
  GivenTin given = naming(*mesh, [&] { return given_tin(std::move(tin)); });
  return {true, input_points(input, std::move(given.points)), std::move(given.constraints),
          given.unused_vertices, std::move(given.number)};
}

}  // namespace hodt::app
