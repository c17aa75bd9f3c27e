// Points at the centres of a raster's cells.
// Tested by tests/io/gdal_test.cpp.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/crs.h"
#include "hodt/io/esri_grid.h"
#include "hodt/io/gdal/dataset.h"
#include "hodt/io/gdal/readers.h"
#include "hodt/io/gdal/spatial_reference.h"
#include "hodt/io/input_text.h"
#include "hodt/io/point_doubts.h"

namespace hodt {

namespace {

/// The centre of a cell.
Point centre(const Affine& g, double column, double row) {
  const double i = column + 0.5, j = row + 0.5;
  return {g[0] + i * g[1] + j * g[2], g[3] + i * g[4] + j * g[5]};
}

bool is_of_driver(GDALDatasetH dataset, std::string_view name) {
  return gdal().GDALGetDescription(gdal().GDALGetDatasetDriver(dataset)) == name;
}

GDALRasterBandH band_of(GDALDatasetH dataset, Index band, const std::string& name) {
  const int count = gdal().GDALGetRasterCount(dataset);
  if (count == 0)
    throw InputError(fmt::format(
        "{} holds several rasters, or none; choose one with gdal_translate (gdalinfo names them)",
        name));
  if (band > static_cast<Index>(count))
    throw ParameterError(
        fmt::format("{} has no band {}; it has {}, counted from 1", name, band, count));
  const GDALRasterBandH chosen =
      gdal().GDALGetRasterBand(dataset, std::max(1, static_cast<int>(band)));
  if (gdal().GDALDataTypeIsComplex(gdal().GDALGetRasterDataType(chosen)))
    throw InputError(fmt::format("{}: its cells are complex numbers, which are no heights", name));
  return chosen;
}

/// Which values stand for none, and what the others mean.
class Values {
 public:
  explicit Values(GDALRasterBandH band) : band_(band) {
    int has = FALSE;
    const double no_data = gdal().GDALGetRasterNoDataValue(band, &has);
    const int flags = gdal().GDALGetMaskFlags(band);
    if (has) no_data_ = as_stored(no_data);
    if (!(flags & (GMF_ALL_VALID | GMF_NODATA))) mask_ = gdal().GDALGetMaskBand(band);
    scale_ = gdal().GDALGetRasterScale(band, &has);
    offset_ = gdal().GDALGetRasterOffset(band, &has);
  }

  /// Reads a row: heights, NaN where there is none. False if that fails.
  bool read(int row, std::vector<double>& heights) {
    const int width = static_cast<int>(heights.size());
    if (!read_row(band_, row, heights.data(), GDT_Float64, width)) return false;
    if (mask_) {
      valid_.resize(heights.size());
      if (!read_row(mask_, row, valid_.data(), GDT_Byte, width)) return false;
    }
    for (std::size_t i = 0; i < heights.size(); ++i) {
      double& z = heights[i];
      if (z == no_data_ || (mask_ && valid_[i] == 0))
        z = std::nan("");
      else
        z = is_scaled() ? z * scale_ + offset_ : z;
    }
    return true;
  }

 private:
  static bool read_row(GDALRasterBandH band, int row, void* to, GDALDataType type, int width) {
    return gdal().GDALRasterIO(band, GF_Read, 0, row, width, 1, to, width, 1, type, 0, 0) ==
           CE_None;
  }
  bool is_scaled() const { return scale_ != 1 || offset_ != 0; }

  /// The nearest number that cells can hold: files write it in decimals.
  double as_stored(double no_data) const {
    if (gdal().GDALGetRasterDataType(band_) != GDT_Float32 || !std::isfinite(no_data))
      return no_data;
    constexpr double limit = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(no_data, -limit, limit));
  }

  GDALRasterBandH band_;
  GDALRasterBandH mask_ = nullptr;
  double no_data_ = std::nan("");  // equal to nothing
  double scale_ = 1, offset_ = 0;
  std::vector<unsigned char> valid_;
};

/// Every so many rows and columns of the band.
PointSet centres(GDALDatasetH dataset, const Affine& g, GDALRasterBandH band, Index stride,
                 const std::string& name) {
  const int columns = gdal().GDALGetRasterXSize(dataset), rows = gdal().GDALGetRasterYSize(dataset);
  const auto taken = [stride](int size) { return std::size_t(size - 1) / stride + 1; };
  GdalErrors errors;
  Values values(band);
  PointSet points;
  const std::size_t most = std::min<std::size_t>(taken(columns) * taken(rows), kNone);
  // Of a huge raster most may be left out.
  points.xy.reserve(std::min(most, std::size_t{1} << 26));
  points.z.reserve(std::min(most, std::size_t{1} << 26));
  std::vector<double> heights(static_cast<std::size_t>(columns));
  for (std::int64_t row = 0; row < rows; row += stride) {
    if (!values.read(static_cast<int>(row), heights))
      throw InputError(
          fmt::format("cannot read row {} of {}, counted from 0: {}", row, name, errors.take()));
    for (std::int64_t column = 0; column < columns; column += stride) {
      const double z = heights[static_cast<std::size_t>(column)];
      if (std::isnan(z)) continue;
      if (std::isinf(z))
        throw InputError(fmt::format(
            "{}: the cell in row {}, column {}, counted from 0, is infinite", name, row, column));
      if (points.size() == most)
        throw InputError(
            fmt::format("{} has more cells than hodt can number ({}); --stride 2 takes "
                        "every second row and column",
                        name, kNone));
      points.xy.push_back(centre(g, static_cast<double>(column), static_cast<double>(row)));
      points.z.push_back(z);
    }
  }
  return points;
}

/// What the band says of its values. Names are those that GDAL's drivers use.
HeightUnit unit_of(GDALRasterBandH band) {
  const char* const said = gdal().GDALGetRasterUnitType(band);
  const std::string unit = said ? said : "";
  for (const auto& [name, metres] : {std::pair{"m", 1.},
                                     {"metre", 1.},
                                     {"meter", 1.},
                                     {"metres", 1.},
                                     {"meters", 1.},
                                     {"cm", 0.01},
                                     {"km", 1000.},
                                     {"ft", 0.3048},
                                     {"foot", 0.3048},
                                     {"feet", 0.3048},
                                     {"US survey foot", 1200. / 3937}})
    if (unit == name) return {metres, unit};
  return {};
}

/// Says so if they are in other units than x and y.
std::vector<std::string> warn_of_unit(const HeightUnit& unit, const std::string& crs) {
  if (unit.metres == 0) return {};
  return height_warnings(crs, unit.metres, unit.name);
}

}  // namespace

PointTable read_raster_points(const std::filesystem::path& path, const PointChoice& choice) {
  const std::string name = display_name(path);
  check_choice(choice, PointKind::raster, name);
  const Dataset dataset = open_dataset(path, DatasetKind::raster);
  if (is_of_driver(dataset.get(), "AAIGrid")) check_esri_grid(read_input(path));
  const GDALRasterBandH band = band_of(dataset.get(), choice.raster.band, name);
  const Index stride = std::max<Index>(1, choice.raster.stride);
  PointTable table;
  const Affine affine = affine_of(dataset.get(), name);
  table.points = centres(dataset.get(), affine, band, stride, name);
  if (table.points.size() == 0) throw InputError(name + ": no cell of it has a value");
  if (stride == 1) table.grid = grid_of(dataset.get(), affine);
  table.points.crs = crs_text(gdal().GDALGetSpatialRef(dataset.get()));
  table.columns.source =
      fmt::format("centres of cells, z = band {} of {}{}", std::max<Index>(choice.raster.band, 1),
                  gdal().GDALGetRasterCount(dataset.get()),
                  stride == 1 ? "" : fmt::format(", every {}th row and column", stride));
  const GDALColorInterp colours = gdal().GDALGetRasterColorInterpretation(band);
  if (GCI_PaletteIndex <= colours && colours <= GCI_BlackBand)
    table.warnings.emplace_back("its cells are colours, not heights, by what the file says");
  table.height_unit = unit_of(band);
  for (std::string& warning : warn_of_no_data(table.points))
    table.warnings.push_back(std::move(warning));
  for (std::string& warning : warn_of_unit(table.height_unit, table.points.crs))
    table.warnings.push_back(std::move(warning));
  return table;
}

}  // namespace hodt
