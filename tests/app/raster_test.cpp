#include "../io/ogr.h"
#include "command_fixture.h"

#include "hodt/io/formats.h"

namespace hodt {
namespace {

class RasterCommand : public test::CommandTest {
 protected:
  void SetUp() override {
    put("pyramid.obj",
        "# crs: EPSG:25832\nv 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 2 2 4\n"
        "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
  }
};

TEST_F(RasterCommand, samples_a_mesh) {
  if (!has_gdal() || !test::has_ogr()) GTEST_SKIP() << "GDAL or gdal-bin is not there";
  const test::Outcome outcome =
      run("raster pyramid.obj --resolution 1 -o dem.tif --hillshade shade.tif");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "raster   4 columns, 4 rows of cells of 1 by 1\n"
            "written  dem.tif\nwritten  shade.tif\n");
  EXPECT_EQ(shell("gdallocationinfo -valonly -geoloc dem.tif 1.5 2.5").out, "3\n");
  EXPECT_EQ(shell("gdallocationinfo -valonly -geoloc shade.tif 0.5 2.5").exit_code, 0);
  ASSERT_EQ(run("raster pyramid.obj --like dem.tif -o again.tif").exit_code, 0);
  EXPECT_EQ(test::content_of(directory_ / "again.tif"), test::content_of(directory_ / "dem.tif"));
}

TEST_F(RasterCommand, refuses_bad_usage) {
  expect_refused("raster pyramid.obj -o a.tif", "--resolution or --like");
  expect_refused("raster pyramid.obj -o a.tif --resolution 1 --like b.tif", "and not both");
  expect_refused("raster pyramid.obj -o a.tif --resolution 0", "--resolution must be positive");
  expect_refused("raster pyramid.obj -o a.tif --resolution x", "--resolution must be a number");
  expect_refused("raster pyramid.obj -o a.asc --resolution 1", "known are .tif, .tiff");
  if (!has_gdal()) return;
  expect_refused("raster pyramid.obj -o a.tif --resolution 1 --hillshade a.tif",
                 "--hillshade names a.tif, which is another output as well");
  expect_refused("raster pyramid.obj -o a.tif --like none.tif", "none.tif");
  put("flat.obj", "v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n");
  expect_refused("raster flat.obj -o a.tif --resolution 1", "needs heights");
  put("twice.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 1 2 4\n");
  expect_refused("raster twice.obj -o a.tif --resolution 1", "twice.obj");
}

// Cells that no disk holds are refused before the work begins, and the message helps.
TEST_F(RasterCommand, refuses_more_cells_than_a_raster_may_have) {
  if (!has_gdal()) GTEST_SKIP() << "GDAL is not there";
  const std::string instead = "choose a larger one, 5e-05 does";
  for (const char* command : {"raster pyramid.obj", "triangulate pyramid.obj"}) {
    const std::string to_file = std::string(command) + " -o a.tif --resolution ";
    expect_refused(to_file + "1e-5", "makes 400000 columns and 400000 rows");
    for (const char* resolution : {"1e-5", "1e-12", "1e-300", "4e-324"})
      expect_refused(to_file + resolution, instead);
    EXPECT_EQ(run(to_file + "5 --hillshade b.tif").exit_code, 0);
  }
  // What is cut out may be small enough, though the terrain is not.
  put("wide.csv", "x,y,z\n0,0,1\n1,0,2\n0,1,3\n1,1,2\n1e9,0,4\n1e9,1e9,5\n0,1e9,1\n");
  put("site.geojson", R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,1],[0,0]]]})");
  expect_refused("triangulate wide.csv -o a.tif --resolution 0.5", "wide.csv: a resolution of 0.5");
  EXPECT_EQ(run("triangulate wide.csv --outline site.geojson -o a.tif --resolution 0.5").exit_code,
            0);
  put("huge.vrt",
      "<VRTDataset rasterXSize='2000000000' rasterYSize='30'><GeoTransform>0,1,0,0,0,-1"
      "</GeoTransform><VRTRasterBand dataType='Float64' band='1'/></VRTDataset>");
  expect_refused("raster pyramid.obj -o a.tif --like huge.vrt",
                 "huge.vrt: a raster of 2000000000 columns and 30 rows is too large");
}

}  // namespace
}  // namespace hodt
