// What stands for the room io/gdal if GDAL was not there when hodt was built: each of its functions
// says so.
// Tested by tests/io/gdal_test.cpp.
#include "hodt/base/error.h"
#include "hodt/io/formats.h"
#include "hodt/io/gdal/crs_facts.h"
#include "hodt/io/gdal/raster.h"
#include "hodt/io/gdal/readers.h"
#include "hodt/io/gdal/writers.h"
#include "hodt/io/raster_file.h"

namespace hodt {

namespace {

[[noreturn]] void refuse() {
  throw ParameterError(
      "this format needs GDAL, without which this hodt was built; install it (on Debian: apt "
      "install "
      "libgdal-dev) and build hodt again");
}

}  // namespace

bool has_gdal() {
  return false;
}

void write_flatgeobuf(const FeatureLayer&, OutputFile&) {
  refuse();
}

void write_shapefile(const FeatureLayer&, OutputFile&) {
  refuse();
}

std::string crs_definition(const std::string&) {
  return {};
}

std::optional<CrsFacts> crs_facts(const std::string&) {
  return std::nullopt;
}

bool are_equal_crs(const std::string&, const std::string&) {
  return false;
}

PointTable read_layer_points(const std::filesystem::path&, const PointChoice&) {
  refuse();
}

PointTable read_raster_points(const std::filesystem::path&, const PointChoice&) {
  refuse();
}

std::string read_layer_features(const std::filesystem::path&, const std::string&,
                                const FeatureTaker&) {
  refuse();
}

struct RasterWriter::State {};

RasterWriter::RasterWriter(const std::filesystem::path&, const Grid&, const std::string&,
                           RasterType, double, std::size_t) {
  refuse();
}

RasterWriter::~RasterWriter() = default;

void RasterWriter::write(std::size_t, std::size_t, void*) {}

void RasterWriter::finish() {}

void require_gdal() {
  refuse();
}

GridOfFile read_grid(const std::filesystem::path&) {
  refuse();
}

}  // namespace hodt
