#include "hodt/io/point_choice.h"

#include <fmt/format.h>

#include "hodt/base/error.h"

namespace hodt {

namespace {

const char* text_of(PointKind kind) {
  switch (kind) {
    case PointKind::table:
      return "a table";
    case PointKind::features:
      return "a file of map features";
    case PointKind::raster:
      return "a raster";
    case PointKind::las:
      return "LAS";
  }
  return "";
}

}  // namespace

void check_choice(const PointChoice& choice, PointKind kind, const std::string& name) {
  const auto refuse = [&](const char* options, const char* what) {
    throw ParameterError(
        fmt::format("{} for {}, and {} is {}", options, what, name, text_of(kind)));
  };
  if (kind != PointKind::table && !choice.columns.empty())
    refuse("--columns is", "tables of points");
  if (kind != PointKind::features && !choice.layer.empty())
    refuse("--layer, --z-field, --no-z and --vertices are", "files of map features");
  if (kind != PointKind::raster && !choice.raster.empty())
    refuse("--band and --stride are", "rasters");
  if (kind != PointKind::las && choice.las)
    refuse("--las-class and --las-return are", "LAS and LAZ files");
}

}  // namespace hodt
