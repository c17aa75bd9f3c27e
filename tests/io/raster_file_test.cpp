#include "hodt/io/raster_file.h"

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "ogr.h"
#include "temporary_directory.h"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"
#include "hodt/io/formats.h"

namespace hodt {
namespace {

using test::content_of;
using test::printed_by;

/// A tent over a square, turned a little.
Tin tent() {
  Tin tin;
  tin.points = {{{500000.25, 5400000.5},
                 {500300.5, 5400010.25},
                 {500310.75, 5400290},
                 {500010, 5400300},
                 {500152.5, 5400151.5}},
                {101.1, 102.2, 103.3, 104.4, 150.7}};
  tin.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  tin.crs = "EPSG:25832";
  return tin;
}

class RasterFile : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_gdal()) GTEST_SKIP() << "this hodt was built without GDAL";
    if (!test::has_ogr()) GTEST_SKIP() << "gdal_translate is not there: install gdal-bin";
  }
  /// The cells as GDAL reads them.
  template <class Value>
  std::vector<Value> cells_of(const std::string& name) const {
    const std::string raw = (directory_ / "cells.raw").string();
    printed_by("gdal_translate -q -of ENVI '" + (directory_ / name).string() + "' '" + raw +
               "' 2>&1");
    const std::string bytes = content_of(raw);
    std::vector<Value> cells(bytes.size() / sizeof(Value));
    std::memcpy(cells.data(), bytes.data(), cells.size() * sizeof(Value));
    return cells;
  }
  std::string info_of(const std::string& name) const {
    return printed_by("gdalinfo '" + (directory_ / name).string() + "' 2>&1");
  }
  void write(const std::string& name, const Tin& tin, const Grid& grid, bool shades) const {
    OutputFile file(directory_ / name);
    shades ? write_hillshade(tin, grid, file) : write_heights(tin, grid, file);
    file.commit();
  }

  test::TemporaryDirectory directory_;
};

TEST_F(RasterFile, takes_the_place_of_all_of_an_old_one) {
  const Grid grid{500000, 5400302, 1, 1, 320, 310};
  for (const bool shades : {false, true}) {
    for (const char* beside : {".ovr", ".aux.xml", ".msk", ".msk.ovr"})
      directory_.file(std::string("old.tif") + beside, "of the old file");
    directory_.file("old.ovr", "of another");
    write("old.tif", tent(), grid, shades);
    EXPECT_EQ(directory_.entries(), 2u) << "and nothing else";
    EXPECT_EQ(info_of("old.tif").find("Overviews"), std::string::npos);
  }
}

TEST_F(RasterFile, has_the_heights_bit_by_bit) {
  const Tin tin = tent();
  // The summit is at the centre of a cell; more rows than are written at once.
  const Grid grid{500000, 5400302, 1, 1, 320, 310};
  write("h \u00e4.tif", tin, grid, false);
  const std::vector<double> cells = cells_of<double>("h \u00e4.tif");
  ASSERT_EQ(cells.size(), grid.columns * grid.rows);
  std::vector<Index> triangles(cells.size());
  std::vector<double> heights(cells.size());
  CellTriangles(tin, grid).fill(0, triangles);
  heights_of_cells(tin, grid, 0, triangles, heights);
  std::size_t outside = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    outside += std::isnan(cells[i]);
    ASSERT_TRUE(cells[i] == heights[i] || (std::isnan(cells[i]) && std::isnan(heights[i])));
  }
  EXPECT_GT(outside, 1000u);
  EXPECT_EQ(cells[150 * 320 + 152], 150.7);
  const std::string info = info_of("h \u00e4.tif");
  for (const char* part : {"Origin = (500000.0", "Pixel Size = (1.0", "Type=Float64",
                           "NoData Value=nan", "\"EPSG\",25832", "Size is 320, 310"})
    EXPECT_NE(info.find(part), std::string::npos) << part << "\n" << info;
}

TEST_F(RasterFile, has_shades_and_cells_of_two_sides) {
  const Tin tin = tent();
  const Grid grid{499990, 5400310, 5, 2.5, 70, 130};
  write("s.tiff", tin, grid, true);
  const std::vector<unsigned char> cells = cells_of<unsigned char>("s.tiff");
  std::vector<Index> triangles(cells.size());
  std::vector<unsigned char> shades(cells.size());
  CellTriangles(tin, grid).fill(0, triangles);
  Hillshade(tin).shades_of_cells(triangles, shades);
  EXPECT_EQ(cells, shades);
  const std::string info = info_of("s.tiff");
  for (const char* part : {"Type=Byte", "NoData Value=0", "Pixel Size = (5.000000000000000,-2.5"})
    EXPECT_NE(info.find(part), std::string::npos) << part << "\n" << info;
}

TEST_F(RasterFile, is_the_same_on_any_number_of_threads) {
  const Tin tin = tent();
  const Grid grid = grid_over(tin, 0.25);
  {
    const ThreadLimit limit(1);
    write("one.tif", tin, grid, false);
  }
  const ThreadLimit limit(3);
  write("three.tif", tin, grid, false);
  EXPECT_EQ(content_of(directory_ / "one.tif"), content_of(directory_ / "three.tif"));
}

// Of a wide raster fewer rows are written at once: they have to be those of its tiles.
TEST_F(RasterFile, may_be_very_wide) {
  const Tin tin = tent();
  const Grid grid{500000, 5400302, 320. / 2200000, 16, 2200000, 20};
  std::vector<double> told;
  {
    OutputFile file(directory_ / "wide.tif");
    write_heights(tin, grid, file, [&](std::string_view, double done) { told.push_back(done); });
    file.commit();
  }
  EXPECT_EQ(told, (std::vector<double>{0, 0.8}));
  const std::string at = "gdallocationinfo -valonly '" + (directory_ / "wide.tif").string() + "' ";
  for (const std::size_t row : {std::size_t{0}, std::size_t{9}, std::size_t{17}}) {
    std::vector<Index> triangles(grid.columns);
    std::vector<double> heights(grid.columns);
    CellTriangles(tin, grid).fill(row, triangles);
    heights_of_cells(tin, grid, row, triangles, heights);
    for (const std::size_t column : {0, 1099999, 2199999})
      EXPECT_EQ(printed_by(at + std::to_string(column) + " " + std::to_string(row)),
                printed_by("printf '%.15g\\n' " + fmt::format("{}", heights[column])))
          << column << ' ' << row;
  }
}

TEST_F(RasterFile, refuses_cells_that_are_all_beside_the_mesh) {
  // Elsewhere, and with a single cell whose centre is beside the mesh.
  for (const Grid& grid : {Grid{0, 100, 1, 1, 20, 600}, Grid{499000, 5401000, 1500, 1500, 1, 1}})
    for (const bool shades : {false, true}) {
      const std::string message =
          test::message_of<InputError>([&] { write("a.tif", tent(), grid, shades); });
      EXPECT_NE(message.find("a.tif: the centre of no cell is on the mesh"), std::string::npos)
          << message;
      EXPECT_EQ(directory_.entries(), 0u);
    }
  write("a.tif", tent(), {500150, 5400160, 10, 10, 1, 1}, false);
}

TEST_F(RasterFile, refuses_more_cells_than_a_raster_may_have) {
  const Grid grid{500000, 5400302, 1, 1, kMostColumns, kMostColumns};
  EXPECT_THROW(write("a.tif", tent(), grid, false), ParameterError);
  EXPECT_THROW(write("a.tif", tent(), grid, true), ParameterError);
  EXPECT_FALSE(std::filesystem::exists(directory_ / "a.tif"));
}

TEST_F(RasterFile, tells_its_cells) {
  const Grid grid{500000, 5400302, 3, 2, 32, 31};
  write("a.tif", tent(), grid, false);
  const GridOfFile found = read_grid(directory_ / "a.tif");
  EXPECT_EQ(found.crs, "EPSG:25832");
  EXPECT_EQ(found.grid.west, grid.west);
  EXPECT_EQ(found.grid.north, grid.north);
  EXPECT_EQ(found.grid.width, grid.width);
  EXPECT_EQ(found.grid.height, grid.height);
  EXPECT_EQ(found.grid.columns, grid.columns);
  EXPECT_EQ(found.grid.rows, grid.rows);
}

TEST_F(RasterFile, tells_no_cells_that_are_turned_or_nowhere) {
  write("a.tif", tent(), {500000, 5400302, 3, 2, 32, 31}, false);
  const std::string from =
      "'" + (directory_ / "a.tif").string() + "' '" + (directory_ / "b.tif").string() + "'";
  printed_by("gdal_translate -q -a_ullr 500000 5400000 500100 5400302 " + from + " 2>&1");
  EXPECT_NE(
      test::message_of<InputError>([&] { read_grid(directory_ / "b.tif"); }).find("is turned"),
      std::string::npos);
  printed_by("gdal_translate -q -of PNG -ot Byte -co WORLDFILE=NO '" +
             (directory_ / "a.tif").string() + "' '" + (directory_ / "c.png").string() +
             "' 2>&1 && rm -f '" + (directory_ / "c.png.aux.xml").string() + "'");
  EXPECT_NE(test::message_of<InputError>([&] {
              read_grid(directory_ / "c.png");
            }).find("does not say where"),
            std::string::npos);
  EXPECT_THROW(read_grid(directory_ / "none.tif"), FileError);
}

TEST(RasterName, tells_the_format) {
  EXPECT_TRUE(is_raster_name("a.TIF"));
  EXPECT_TRUE(is_raster_name("folder/a.tiff"));
  EXPECT_FALSE(is_raster_name("a.tif.gz"));
  EXPECT_FALSE(is_raster_name("tif"));
  EXPECT_THROW(check_raster_output("a.asc"), ParameterError);
}

}  // namespace
}  // namespace hodt
