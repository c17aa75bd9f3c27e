#include "hodt/io/crs.h"

#include <string>

#include "temporary_directory.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/io/formats.h"

namespace hodt {
namespace {

using test::message_of;

TEST(Crs, IsNamedByACode) {
  EXPECT_EQ(parse_crs("--crs", "EPSG:25832"), "EPSG:25832");
  EXPECT_EQ(parse_crs("--crs", "epsg:25832"), "EPSG:25832");
  for (const char* bad : {"25832", "EPSG", "EPSG:", "EPSG:x", "x.prj", "/etc/passwd", "UTM 32",
                          "http://a.org/25832", "EPSG:25832 "})
    EXPECT_NE(message_of<ParameterError>([&] {
                parse_crs("--crs", bad);
              }).find(std::string("like EPSG:25832, not '") + bad),
              std::string::npos)
        << bad;
}

TEST(Crs, IsOneThatThereIs) {
  if (!has_gdal()) GTEST_SKIP() << "built without GDAL";
  EXPECT_NE(message_of<ParameterError>([] {
              parse_crs("--crs", "EPSG:99999999");
            }).find("not 'EPSG:99999999'"),
            std::string::npos);
  EXPECT_EQ(parse_crs("--crs", "EPSG:7415"), "EPSG:7415");
  for (const char* text : {"EPSG:4978", "EPSG:7837", "+proj=geocent +datum=WGS84"})
    EXPECT_NE(message_of<ParameterError>([&] {
                parse_crs("--crs", text);
              }).find("is geocentric or of heights alone"),
              std::string::npos)
        << text;
  for (const char* text : {"EPSG:4979", "EPSG:4326", "EPSG:25832+7837", "EPSG:2225"})
    EXPECT_EQ(parse_crs("--crs", text).empty(), false) << text;
  const std::string wkt = parse_crs("--crs", "+proj=tmerc +lon_0=7.5 +units=m +datum=WGS84");
  EXPECT_TRUE(wkt.starts_with("PROJCRS[")) << wkt;
  EXPECT_EQ(wkt.find('\n'), std::string::npos);
  EXPECT_EQ(parse_crs("--crs", wkt), wkt);
}

TEST(Crs, NamesOfOgcAreCodes) {
  EXPECT_EQ(crs_of_urn("urn:ogc:def:crs:EPSG::25832"), "EPSG:25832");
  EXPECT_EQ(crs_of_urn("urn:ogc:def:crs:EPSG:9.9:4326"), "EPSG:4326");
  EXPECT_EQ(crs_of_urn("urn:ogc:def:crs:OGC:1.3:CRS84"), "OGC:CRS84");
  EXPECT_EQ(crs_of_urn("EPSG:31467"), "EPSG:31467");
  EXPECT_EQ(crs_of_urn("urn:ogc:def:crs:x"), "urn:ogc:def:crs:x");
  EXPECT_EQ(crs_of_urn("ours"), "ours");
}

TEST(Crs, AreTheSameIfTheirDefinitionsAre) {
  EXPECT_TRUE(is_same_crs("EPSG:25832", "EPSG:25832"));
  EXPECT_FALSE(is_same_crs("EPSG:25832", "EPSG:25833"));
  EXPECT_FALSE(is_same_crs("EPSG:25832", ""));
  if (!has_gdal()) return;
  EXPECT_TRUE(is_same_crs("OGC:CRS84", "EPSG:4326")) << "only the axes are in another order";
  EXPECT_FALSE(is_same_crs("EPSG:4326", "EPSG:4258"));
  EXPECT_TRUE(is_same_crs("EPSG:4326", "EPSG:4979")) << "one of them without heights";
  EXPECT_TRUE(is_same_crs("EPSG:25832+7837", "EPSG:25832")) << "one of them without heights";
  EXPECT_FALSE(is_same_crs("EPSG:25832+7837", "EPSG:25832+5773")) << "heights of two kinds";
  EXPECT_FALSE(is_same_crs("EPSG:25832", "nonsense"));
}

TEST(Crs, AreWarnedOfWhereLengthsAreNone) {
  if (!has_gdal()) GTEST_SKIP() << "built without GDAL";
  EXPECT_TRUE(crs_warnings("").empty());
  EXPECT_TRUE(crs_warnings("EPSG:25832").empty());
  EXPECT_TRUE(crs_warnings("EPSG:7415").empty()) << "metres, and metres";
  EXPECT_TRUE(crs_warnings("nonsense").empty());
  for (const char* degrees : {"EPSG:4326", "EPSG:4979", "OGC:CRS84", "EPSG:9518"}) {
    const auto warnings = crs_warnings(degrees);
    ASSERT_EQ(warnings.size(), 1u) << degrees;
    EXPECT_NE(warnings[0].find("x and y are degrees"), std::string::npos);
    EXPECT_NE(warnings[0].find("gdalwarp -t_srs"), std::string::npos);
  }
  // Texas in feet, heights in metres; and both in feet, of two kinds.
  const auto warnings = crs_warnings("EPSG:2277+5703");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("heights are in metre, x and y in US survey foot"), std::string::npos)
      << warnings[0];
  EXPECT_TRUE(crs_warnings("EPSG:2277+8228").empty());
}

TEST(Crs, MayBeJoinedWithOneOfHeights) {
  EXPECT_EQ(crs_with_heights("", 7837), "");
  EXPECT_EQ(crs_with_heights("ours", 7837), "");
  if (!has_gdal()) return;
  EXPECT_EQ(crs_with_heights("EPSG:25832", 7837), parse_crs("--crs", "EPSG:25832+7837"));
  EXPECT_EQ(crs_with_heights("EPSG:25832", 25833), "") << "no system of heights";
  EXPECT_EQ(crs_with_heights("EPSG:25832", 5103), "") << "a datum";
  EXPECT_NEAR(crs_units(crs_with_heights("EPSG:2277", 6360)).metres, 0.3048006, 1e-7);
}

TEST(Crs, AreWarnedOfWhatAFileSaysOfHeights) {
  if (!has_gdal()) GTEST_SKIP() << "built without GDAL";
  EXPECT_EQ(height_warnings("EPSG:25832", 0.3048, "ft").size(), 1u);
  EXPECT_EQ(height_warnings("EPSG:25832+7837", 0.3048, "ft").size(), 1u);
  EXPECT_EQ(height_warnings("EPSG:25832", 1, "m").size(), 0u);
  EXPECT_EQ(height_warnings("EPSG:2277", 0.3048, "ft").size(), 0u) << "the two kinds of feet";
  EXPECT_EQ(height_warnings("EPSG:2277+5703", 1, "m").size(), 0u) << "the system says it";
  EXPECT_EQ(height_warnings("EPSG:4326", 0.3048, "ft").size(), 0u) << "degrees have a warning";
  EXPECT_EQ(height_warnings("", 0.3048, "ft").size(), 0u);
}

TEST(Crs, HaveNamesForPeople) {
  EXPECT_EQ(crs_title(""), "");
  if (!has_gdal()) return;
  EXPECT_EQ(crs_title("EPSG:25832"), "EPSG:25832 (ETRS89 / UTM zone 32N)");
  EXPECT_EQ(crs_title("nonsense"), "nonsense");
}

}  // namespace
}  // namespace hodt
