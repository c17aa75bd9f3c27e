#include "hodt/io/gdal/dataset.h"

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

}  // namespace hodt
