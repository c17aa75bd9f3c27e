#include "hodt/io/tin_layer.h"

#include <string>
#include <vector>

#include "ogr.h"
#include "temporary_directory.h"
#include <gtest/gtest.h>

#include "hodt/io/tin_file.h"
#include "hodt/tin/slope.h"

namespace hodt {
namespace {

/// Two triangles, one level, of coordinates that need all their bits.
Tin roof() {
  Tin tin;
  tin.points.xy = {{1e6 + 0.1, 5e6 + 0.3},
                   {1e6 + 1.1, 5e6 + 0.3},
                   {1e6 + 1.3, 5e6 + 1.7},
                   {1e6 + 0.1, 5e6 + 2.0 / 3}};
  tin.points.z = {0.1 + 0.2, 0.1 + 0.2, 0.1 + 0.2, 1e-17};
  tin.triangles = {{0, 1, 2}, {0, 2, 3}};
  tin.crs = "EPSG:25832";
  return tin;
}

class TinLayer : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!test::has_ogr()) GTEST_SKIP() << "needs the programs of Debian's package gdal-bin";
    if (!test::writes(GetParam())) GTEST_SKIP() << "built without GDAL";
  }
  std::filesystem::path written(const Tin& tin) const {
    write_tin(tin, directory_ / (std::string("a") + GetParam()));
    return directory_ / (std::string("a") + GetParam());
  }

  test::TemporaryDirectory directory_;
};

TEST_P(TinLayer, HasATriangleAFeature) {
  Tin tin = roof();
  tin.order = {0, 3};
  const std::filesystem::path path = written(tin);
  std::vector<test::OgrFeature> features = test::ogr_features(path);
  ASSERT_EQ(features.size(), 2u);
  if (features[0].values[0] == "3") std::swap(features[0], features[1]);  // sorted by place
  for (std::size_t t = 0; t < 2; ++t) {
    EXPECT_EQ(features[t].type, 1003u);
    ASSERT_EQ(features[t].positions.size(), 4u);
    for (std::size_t c = 0; c < 4; ++c) {
      const Index v = tin.triangles[t][c % 3];
      const std::array<double, 3> expected = {tin.points.xy[v].x, tin.points.xy[v].y,
                                              tin.points.z[v]};
      EXPECT_EQ(features[t].positions[c], expected);
    }
  }
  ASSERT_EQ(features[0].values.size(), 4u);
  EXPECT_EQ(features[0].values[0], "0");
  EXPECT_EQ(features[0].values[1], "0");
  EXPECT_EQ(std::stod(features[0].values[2]), 0);
  EXPECT_EQ(features[0].values[3], "\\N") << "it is level";
  const Slope slope = slope_of(tin.points.xy[0], tin.points.xy[2], tin.points.xy[3],
                               tin.points.z[0], tin.points.z[2], tin.points.z[3]);
  EXPECT_EQ(features[1].values[0], "3");
  EXPECT_EQ(features[1].values[1], "1");
  EXPECT_NEAR(std::stod(features[1].values[2]), slope.slope, 1e-12);
  EXPECT_NEAR(std::stod(features[1].values[3]), *slope.aspect, 1e-12);
  const std::string info = test::ogrinfo(path);
  EXPECT_NE(info.find("ID[\"EPSG\",25832]]"), std::string::npos) << info;
  for (const char* field :
       {"\norder: Integer", "\nchanged: Integer", "\nslope: Real", "\naspect: Real"})
    EXPECT_NE(info.find(field), std::string::npos) << info;
}

TEST_P(TinLayer, HasNoFieldsOfWhatIsNotKnown) {
  Tin tin = roof();
  tin.points.z.clear();
  const std::vector<test::OgrFeature> features = test::ogr_features(written(tin));
  ASSERT_EQ(features.size(), 2u);
  EXPECT_EQ(features[0].type, 3u);
  if (GetParam() != std::string(".shp")) {  // where a table has a column in any case
    EXPECT_TRUE(features[0].values.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, TinLayer, testing::Values(".geojson", ".gpkg", ".fgb", ".shp"),
                         [](const auto& format) { return std::string(format.param).substr(1); });

}  // namespace
}  // namespace hodt
