#include "hodt/io/feature_file.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "ogr.h"
#include "temporary_directory.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/io/crs_name.h"

namespace hodt {
namespace {

using test::content_of;
using test::message_of;
using test::ogr_features;
using test::OgrFeature;
using test::ogrinfo;
using test::TemporaryDirectory;

/// Coordinates that only all bits tell apart.
LayerFeature feature_of(GeometryKind kind, std::size_t i, bool heights) {
  const double x = 512345.1 + double(i) / 3, y = std::nextafter(5512345.7, double(i) + 1);
  const std::size_t count = kind == GeometryKind::point ? 1 : kind == GeometryKind::line ? 2 : 3;
  const std::vector<Point> corners = {{x, y}, {x + 0.1, y}, {x, y + 0.1}};
  const std::vector<double> z = {-0.1 * double(i), 1e-300, 1.7e300};
  LayerFeature feature;
  feature.xy.assign(corners.begin(), corners.begin() + std::ptrdiff_t(count));
  if (heights) feature.z.assign(z.begin(), z.begin() + std::ptrdiff_t(count));
  feature.values = {std::int64_t{-7} + std::int64_t(i), 0.1 * double(i),
                    "drain\u00fc \"a\" " + std::to_string(i)};
  if (i == 1) feature.values = {{}, std::numeric_limits<double>::quiet_NaN(), {}};
  return feature;
}

FeatureLayer layer_of(GeometryKind kind, std::size_t count, bool heights = true) {
  FeatureLayer layer;
  layer.geometry = kind;
  layer.has_heights = heights;
  layer.fields = {
      {"order", FieldType::integer}, {"slope", FieldType::real}, {"kind", FieldType::text}};
  layer.count = count;
  layer.make = [=](std::size_t i, LayerFeature& feature) {
    feature = feature_of(kind, i, heights);
  };
  return layer;
}

class FeatureFile : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!test::has_ogr()) GTEST_SKIP() << "needs the programs of Debian's package gdal-bin";
    if (!test::writes(GetParam())) GTEST_SKIP() << "built without GDAL";
  }
  std::string name(const std::string& stem) const { return stem + GetParam(); }
  std::filesystem::path written(const FeatureLayer& layer, const std::string& stem) const {
    write_features(layer, directory_ / name(stem));
    return directory_ / name(stem);
  }

  TemporaryDirectory directory_;
};

constexpr GeometryKind kKinds[] = {GeometryKind::point, GeometryKind::line, GeometryKind::polygon};

TEST_P(FeatureFile, GivesEveryBitBack) {
  for (const GeometryKind kind : kKinds) {
    for (const bool heights : {true, false}) {
      constexpr std::size_t count = 5;
      const std::vector<OgrFeature> read =
          ogr_features(written(layer_of(kind, count, heights), "a"));
      ASSERT_EQ(read.size(), count);
      for (std::size_t i = 0; i < count; ++i) {
        const LayerFeature expected = feature_of(kind, i, heights);
        EXPECT_EQ(read[i].type, unsigned(kind) + 1 + (heights ? 1000 : 0));
        const std::size_t corners = expected.xy.size();
        ASSERT_EQ(read[i].positions.size(), corners + (kind == GeometryKind::polygon ? 1 : 0));
        for (std::size_t c = 0; c < read[i].positions.size(); ++c) {
          const Point p = expected.xy[c % corners];
          EXPECT_EQ(read[i].positions[c][0], p.x);
          EXPECT_EQ(read[i].positions[c][1], p.y);
          if (heights) {
            EXPECT_EQ(read[i].positions[c][2], expected.z[c % corners]);
          }
        }
      }
    }
  }
}

TEST_P(FeatureFile, GivesAttributesBack) {
  const std::vector<OgrFeature> read =
      ogr_features(written(layer_of(GeometryKind::point, 12), "a"));
  ASSERT_EQ(read.size(), 12u);
  for (std::size_t i = 0; i < read.size(); ++i) {
    ASSERT_EQ(read[i].values.size(), 3u);
    if (i == 1) {
      EXPECT_EQ(read[i].values, std::vector<std::string>({"\\N", "\\N", "\\N"}));
      continue;
    }
    EXPECT_EQ(std::stol(read[i].values[0]), long(i) - 7);
    EXPECT_DOUBLE_EQ(std::stod(read[i].values[1]), 0.1 * double(i));
    EXPECT_EQ(read[i].values[2], "drain\u00fc \"a\" " + std::to_string(i));
  }
}

TEST_P(FeatureFile, MayBeEmpty) {
  const std::filesystem::path path = written(layer_of(GeometryKind::line, 0), "a");
  EXPECT_TRUE(ogr_features(path).empty());
  EXPECT_NE(ogrinfo(path).find("Feature Count: 0"), std::string::npos);
}

TEST_P(FeatureFile, NamesTheLayerAsTheFile) {
  for (const std::string stem :
       {"a", "with blanks and 'quotes'", "H\u00f6hen \u5c71", "a.b", "1", "select"}) {
    // The shell's quotes end and begin around one.
    std::filesystem::path path = written(layer_of(GeometryKind::point, 2), stem);
    EXPECT_TRUE(std::filesystem::exists(path));
    if (stem.find('\'') == std::string::npos) {
      EXPECT_NE(ogrinfo(path).find("Layer name: " + stem + "\n"), std::string::npos)
          << ogrinfo(path);
    }
  }
}

TEST_P(FeatureFile, ReplacesAnOldFile) {
  written(layer_of(GeometryKind::point, 100), "a");
  EXPECT_EQ(ogr_features(written(layer_of(GeometryKind::line, 3), "a")).size(), 3u);
}

TEST_P(FeatureFile, SaysWhereItIs) {
  FeatureLayer layer = layer_of(GeometryKind::polygon, 3);
  layer.crs = "EPSG:25832";
  EXPECT_NE(ogrinfo(written(layer, "a")).find("ID[\"EPSG\",25832]]"), std::string::npos);
  layer.crs = "";
  EXPECT_EQ(ogrinfo(written(layer, "a")).find("EPSG\",25832"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Formats, FeatureFile, testing::Values(".geojson", ".gpkg", ".fgb", ".shp"),
                         [](const auto& format) { return std::string(format.param).substr(1); });

TEST(FeatureFileNames, UnknownOnesAreRefused) {
  const TemporaryDirectory directory;
  const auto write = [&] { write_features(layer_of(GeometryKind::point, 1), directory / "a.obj"); };
  EXPECT_NE(message_of<ParameterError>(write).find("cannot write features to"), std::string::npos);
  EXPECT_EQ(directory.entries(), 0u);
}

TEST(CrsName, CodesAreFound) {
  const auto code = [](const char* crs) {
    const auto found = crs_code(crs);
    return found ? found->authority + " " + std::to_string(found->number) : std::string();
  };
  EXPECT_EQ(code("EPSG:25832"), "EPSG 25832");
  EXPECT_EQ(code("ESRI:102003"), "ESRI 102003");
  EXPECT_EQ(
      code(
          "PROJCS[\"a\",GEOGCS[\"b\",AUTHORITY[\"EPSG\",\"4258\"]],AUTHORITY[\"EPSG\",\"25832\"]]"),
      "EPSG 25832");
  EXPECT_EQ(code("PROJCRS[\"a\",BASEGEOGCRS[\"b\",ID[\"EPSG\",4258]],ID[\"EPSG\",25832]]"),
            "EPSG 25832");
  EXPECT_EQ(code("PROJCS[\"a\",GEOGCS[\"b\",AUTHORITY[\"EPSG\",\"4258\"]]]"), "");
  for (const char* none :
       {"", "EPSG", "EPSG:", "EPSG:a", "EPSG:-1", "EPSG:1x", ":1", "LOCAL_CS[\"a\"]", "]]"})
    EXPECT_EQ(code(none), "") << none;
  EXPECT_EQ(crs_urn("EPSG:25832"), "urn:ogc:def:crs:EPSG::25832");
  EXPECT_EQ(crs_urn("EPSG:4326"), "urn:ogc:def:crs:OGC:1.3:CRS84");
}

}  // namespace
}  // namespace hodt
