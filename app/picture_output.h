// The options --picture and --window: what an objective did, to look at.
// Tested by tests/app/picture_test.cpp.
#pragma once

#include <span>
#include <string>

#include "app/common.h"
#include "app/outputs.h"

#include "hodt/pipeline.h"
#include "hodt/pipeline/join_lines.h"

namespace hodt::app {

struct PictureArguments {
  std::string file;
  std::string window;

  bool any() const { return !file.empty(); }
};

void add_picture(CLI::App& command, PictureArguments& arguments);

/// Throws ParameterError if the picture's name ends in no known way, the window is none, or the
/// file is one of the others: of those that are read, or that are written; FileError if it cannot
/// be written.
void check_picture(const PictureArguments& arguments, std::span<const std::string> read,
                   std::span<const std::string> written);

/// Draws the result beside the Delaunay triangulation, which it tells, if a picture was asked for.
/// `name` is what the points are called, `order` the order that was asked for.
void write_picture(const PictureArguments& arguments, const std::string& name,
                   const std::string& order, const TriangulateResult& result, const Joined& joined,
                   Outputs& outputs);

}  // namespace hodt::app
