#include "hodt/io/gdal/dataset.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/file_name.h"
#include "hodt/io/input_text.h"

namespace hodt {

namespace {

/// What GDAL calls the file. An absolute path is no name of a service.
std::string gdal_name(const std::filesystem::path& path) {
  const std::string name = std::filesystem::absolute(path).string();
  return is_packed_name(path) ? "/vsigzip/" + name : name;
}

}  // namespace

Dataset open_dataset(const std::filesystem::path& path, DatasetKind kind) {
  require_readable(path);
  const unsigned flags = GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR |
                         (kind == DatasetKind::raster ? GDAL_OF_RASTER : GDAL_OF_VECTOR);
  GdalErrors errors;
  Dataset dataset(gdal().GDALOpenEx(gdal_name(path).c_str(), flags, nullptr, nullptr, nullptr));
  if (!dataset)
    throw InputError(fmt::format("cannot read {}: {}", display_name(path), errors.take()));
  return dataset;
}

Affine affine_of(GDALDatasetH dataset, const std::string& name) {
  Affine g{};
  if (gdal().GDALGetGeoTransform(dataset, g.data()) != CE_None)
    throw InputError(
        fmt::format("{} does not say where its cells are on the map; georeference it, with "
                    "gdalwarp for example",
                    name));
  const bool is_finite = std::all_of(g.begin(), g.end(), [](double v) { return std::isfinite(v); });
  if (!is_finite || g[1] * g[5] == g[2] * g[4])
    throw InputError(fmt::format("{} has cells of no size", name));
  return g;
}

std::optional<Grid> grid_of(GDALDatasetH dataset, const Affine& g) {
  const bool is_upright = g[2] == 0 && g[4] == 0 && g[1] > 0 && g[5] < 0;
  if (!is_upright) return std::nullopt;
  return Grid{g[0],
              g[3],
              g[1],
              -g[5],
              static_cast<std::size_t>(gdal().GDALGetRasterXSize(dataset)),
              static_cast<std::size_t>(gdal().GDALGetRasterYSize(dataset))};
}

}  // namespace hodt
