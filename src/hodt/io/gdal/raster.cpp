#include "hodt/io/gdal/raster.h"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/gdal/dataset.h"
#include "hodt/io/gdal/spatial_reference.h"
#include "hodt/io/gdal/writers.h"
#include "hodt/io/input_text.h"
#include "hodt/io/raster_file.h"

namespace hodt {

namespace {

GDALDatasetH create(const std::filesystem::path& path, const Grid& grid, RasterType type,
                    std::size_t tile_rows) {
  const std::string rows = std::to_string(tile_rows);
  char** options = nullptr;
  for (const auto& [key, value] : {std::pair{"TILED", "YES"},
                                   {"BLOCKYSIZE", rows.c_str()},
                                   {"COMPRESS", "DEFLATE"},
                                   {"PREDICTOR", type == RasterType::height ? "3" : "2"},
                                   {"BIGTIFF", "IF_SAFER"},
                                   {"NUM_THREADS", "ALL_CPUS"}})
    options = gdal().CSLSetNameValue(options, key, value);
  const GDALDatasetH dataset = gdal().GDALCreate(
      gdal().GDALGetDriverByName("GTiff"), path.c_str(), static_cast<int>(grid.columns),
      static_cast<int>(grid.rows), 1, type == RasterType::height ? GDT_Float64 : GDT_Byte, options);
  gdal().CSLDestroy(options);
  return dataset;
}

}  // namespace

struct RasterWriter::State {
  GdalErrors errors;
  Dataset dataset;
  RasterType type;
  int columns;

  /// A system that is not known is not lost in silence.
  void set_crs(const std::string& crs) {
    std::string definition = crs_definition(crs);
    // The older text has no heights beside longitude and latitude.
    if (const Reference reference = reference_of(crs); definition.empty() && reference)
      definition = wkt_of(reference.get(), "WKT2_2019");
    if (definition.empty() ||
        gdal().GDALSetProjection(dataset.get(), definition.c_str()) != CE_None)
      throw ParameterError(fmt::format(
          "GDAL does not know the coordinate reference system {}; name another by --crs", crs));
  }
  [[noreturn]] void fail() { fail(errors.take()); }
  [[noreturn]] static void fail(const std::string& why) {
    throw FileError(fmt::format("cannot write the raster: {}", why));
  }
};

RasterWriter::RasterWriter(const std::filesystem::path& path, const Grid& grid,
                           const std::string& crs, RasterType type, double no_data,
                           std::size_t tile_rows)
    : state_(new State{{}, Dataset(), type, static_cast<int>(grid.columns)}) {
  state_->dataset.reset(create(path, grid, type, tile_rows));
  if (!state_->dataset) state_->fail();
  GDALDatasetH dataset = state_->dataset.get();
  Affine affine = {grid.west, grid.width, 0, grid.north, 0, -grid.height};
  gdal().GDALSetGeoTransform(dataset, affine.data());
  if (!crs.empty()) state_->set_crs(crs);
  gdal().GDALSetRasterNoDataValue(gdal().GDALGetRasterBand(dataset, 1), no_data);
}

RasterWriter::~RasterWriter() = default;

void RasterWriter::write(std::size_t first_row, std::size_t rows, void* cells) {
  const GDALDataType type = state_->type == RasterType::height ? GDT_Float64 : GDT_Byte;
  if (gdal().GDALRasterIO(gdal().GDALGetRasterBand(state_->dataset.get(), 1), GF_Write, 0,
                          static_cast<int>(first_row), state_->columns, static_cast<int>(rows),
                          cells, state_->columns, static_cast<int>(rows), type, 0, 0) != CE_None)
    state_->fail();
}

void RasterWriter::finish() {
  state_->dataset.reset();
  if (const std::string error = state_->errors.take(); !error.empty()) State::fail(error);
}

void require_gdal() {
  gdal();
}

GridOfFile read_grid(const std::filesystem::path& path) {
  const Dataset dataset = open_dataset(path, DatasetKind::raster);
  const std::optional<Grid> grid =
      grid_of(dataset.get(), affine_of(dataset.get(), display_name(path)));
  if (!grid)
    throw InputError(
        fmt::format("{} is turned: its columns do not go east and its rows south; turn it with "
                    "gdalwarp first",
                    display_name(path)));
  return {*grid, crs_text(gdal().GDALGetSpatialRef(dataset.get()))};
}

}  // namespace hodt
