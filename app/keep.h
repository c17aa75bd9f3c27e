// The options --keep and --min-pit-depth: real pits that stay.
#pragma once

#include <string>

#include "app/common.h"
#include "app/points_input.h"

#include "hodt/pipeline.h"

namespace hodt::app {

struct KeepArguments {
  std::string places;
  std::string min_pit_depth;

  bool any() const { return !places.empty() || !min_pit_depth.empty(); }
};

void add_keep(CLI::App& command, KeepArguments& arguments);

/// Sets what the options say, and reads the file. Throws ParameterError also if `input` is to be
/// standard input as well.
void read_keep(const KeepArguments& arguments, const PointsInput& input,
               TriangulateOptions& options);

/// Says on standard error what may be wrong with the places. For the end of a run.
void print_warnings(const Places& keep);

/// "3 local minima", and how many polygons no point is in, if any.
std::string kept_text(std::size_t kept, std::size_t empty_polygons);

}  // namespace hodt::app
