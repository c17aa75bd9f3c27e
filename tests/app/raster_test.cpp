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
  expect_refused("raster pyramid.obj -o a.tif --resolution 1e-12", "choose a larger one");
  put("flat.obj", "v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n");
  expect_refused("raster flat.obj -o a.tif --resolution 1", "needs heights");
  put("twice.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 1 2 4\n");
  expect_refused("raster twice.obj -o a.tif --resolution 1", "twice.obj");
}

}  // namespace
}  // namespace hodt
