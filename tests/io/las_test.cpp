// LAS and LAZ: files of the tests' own writer, and compressed ones beside their twins that are not.
#include <algorithm>
#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include "las_writer.h"
#include "temporary_directory.h"
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"
#include "hodt/io/crs.h"
#include "hodt/io/formats.h"
#include "hodt/io/las/las_crs.h"
#include "hodt/io/las/las_reader.h"
#include "hodt/io/las_table.h"
#include "hodt/io/point_file.h"

namespace hodt {
namespace {

using test::input_of;
using test::LasPoint;
using test::LasWriter;
using test::message_of;

/// One of each kind that is treated its own way, three times.
std::vector<LasPoint> kinds_of_points() {
  std::vector<LasPoint> points;
  for (int i = 0; i < 3; ++i) {
    const std::int32_t x = 100 * i;
    points.push_back({x + 1, -2, 3, 2, 1, 1});
    points.push_back({x + 2, 2147483647, -2147483647 - 1, 2, 1, 2});
    points.push_back({x + 3, 7, 8, 2, 2, 2});
    points.push_back({x + 4, 7, 8, 5, 1, 3});
    points.push_back({x + 5, 7, 8, 5, 3, 3});
    points.push_back({x + 6, 7, 8, 2, 1, 1, true, true, false, true});
    points.push_back({x + 7, 7, 8, 2, 1, 1, false, false, true});
    points.push_back({x + 8, 7, 8, 0, 0, 0});
  }
  return points;
}

struct Version {
  int format;
  int minor;
};

std::vector<Version> versions() {
  std::vector<Version> all;
  for (const int minor : {0, 1, 2, 3, 4})
    for (int format = 0; format <= 10; ++format)
      if (format < 6 || minor == 4) all.push_back({format, minor});
  return all;
}

LasWriter writer_of(const Version& version) {
  LasWriter writer(version.format, version.minor);
  writer.points = kinds_of_points();
  writer.scale[1] = 0.1;
  writer.offset[0] = 400000.125;
  writer.offset[1] = -5e6;
  writer.offset[2] = 0.1;
  return writer;
}

/// The points' x as stored, less what tells the three times apart: 1, 2, 3, ... once each.
std::vector<int> taken(const LasWriter& writer, std::string_view classes,
                       std::string_view returns = "") {
  const LasPoints las = read_las(input_of(writer.bytes()), parse_las_choice(classes, returns));
  std::vector<int> numbers;
  for (std::size_t i = 0; i < las.points.size() / 3; ++i)
    numbers.push_back(int(std::lround((las.points.xy[i].x - writer.offset[0]) / writer.scale[0])));
  EXPECT_EQ(las.points.size(), 3 * numbers.size());
  EXPECT_EQ(las.counts.taken, las.points.size());
  return numbers;
}

TEST(Las, ScalesAndShiftsEachFormatExactly) {
  for (const Version& version : versions()) {
    SCOPED_TRACE(testing::Message() << "format " << version.format << ", LAS 1." << version.minor);
    for (const int extra : {0, 3}) {
      LasWriter writer = writer_of(version);
      writer.extra_bytes = extra;
      const LasPoints las = read_las(input_of(writer.bytes()), parse_las_choice("all", ""));
      std::size_t at = 0;
      for (const LasPoint& point : writer.points) {
        if (point.withheld) continue;
        ASSERT_LT(at, las.points.size());
        // A product rounded, then a sum rounded.
        volatile double x = point.x * 0.01, y = point.y * 0.1, z = point.z * 0.001;
        EXPECT_EQ(las.points.xy[at].x, x + 400000.125);
        EXPECT_EQ(las.points.xy[at].y, y - 5e6);
        EXPECT_EQ(las.points.z[at], z + 0.1);
        ++at;
      }
      EXPECT_EQ(at, las.points.size());
    }
  }
}

TEST(Las, TakesTheClassesAndReturnsAskedFor) {
  for (const Version& version : versions()) {
    SCOPED_TRACE(testing::Message() << "format " << version.format << ", LAS 1." << version.minor);
    const LasWriter writer = writer_of(version);
    EXPECT_EQ(taken(writer, ""), (std::vector{1, 2, 3, 6})) << "ground";
    EXPECT_EQ(taken(writer, "2"), (std::vector{1, 2, 3, 6}));
    EXPECT_EQ(taken(writer, "5,0"), (std::vector{4, 5, 8}));
    EXPECT_EQ(taken(writer, "all"), (std::vector{1, 2, 3, 4, 5, 6, 8})) << "7 is withheld";
    EXPECT_EQ(taken(writer, "", "last"), (std::vector{1, 3, 6}));
    EXPECT_EQ(taken(writer, "all", "last"), (std::vector{1, 3, 5, 6, 8}));
    EXPECT_EQ(taken(writer, "all", "first"), (std::vector{1, 2, 4, 6, 8}));
    EXPECT_EQ(taken(writer, "2,5", "all"), (std::vector{1, 2, 3, 4, 5, 6}));
  }
}

TEST(Las, LongFormatsHaveAllClassesAndReturns) {
  LasWriter writer(6, 4);
  writer.points = {{1, 0, 0, 255, 15, 15}, {2, 0, 0, 34, 9, 15}, {3, 0, 0, 34, 15, 15}};
  const LasPoints las = read_las(input_of(writer.bytes()), parse_las_choice("34,255", "last"));
  ASSERT_EQ(las.points.size(), 2u);
  EXPECT_EQ(las.points.xy[0].x, 0.01);
  EXPECT_EQ(las.points.xy[1].x, 0.03);
}

TEST(Las, WithoutGroundAllClassesAreTaken) {
  LasWriter writer(1, 2);
  writer.points = {{1, 0, 0, 1}, {2, 0, 0, 0}, {3, 0, 0, 2, 1, 1, false, false, true}};
  const LasPoints las = read_las(input_of(writer.bytes()));
  EXPECT_EQ(las.points.size(), 2u);
  EXPECT_TRUE(las.counts.all_classes);
  EXPECT_EQ(text_of(las.counts), "all classes: 2 of 3 points, 1 withheld");
}

TEST(Las, SaysWhatWasTaken) {
  const LasPoints las = read_las(input_of(writer_of({1, 2}).bytes()));
  EXPECT_EQ(text_of(las.counts), "class 2 (ground): 12 of 24 points, 3 withheld");
  EXPECT_EQ(las.counts.other_class, 9u);
  EXPECT_EQ(las.counts.other_return, 0u);
  const LasPoints last =
      read_las(input_of(writer_of({1, 2}).bytes()), parse_las_choice("9,5,2", "last"));
  EXPECT_EQ(text_of(last.counts),
            "class 2 (ground), 5 (high vegetation), last returns: 12 of 24 points, 3 withheld");
  EXPECT_EQ(last.counts.other_class, 3u);
  EXPECT_EQ(last.counts.other_return, 6u);
  EXPECT_EQ(las_class_name(200), "200");
}

TEST(Las, NoPointAskedForIsAnErrorThatSaysWhatThereIs) {
  const std::string message = message_of<InputError>([] {
    read_las(input_of(writer_of({1, 2}).bytes()), parse_las_choice("9", ""));
  });
  EXPECT_EQ(message,
            "cloud.las: none of its 24 points is of the classes and returns asked for; 3 withheld, "
            "the others are of class 0 (never classified), 2 (ground), 5 (high vegetation)");
}

TEST(Las, ChoicesAreNumbersOrWords) {
  EXPECT_EQ(parse_las_choice("2,9", "").listed.count(), 2u);
  EXPECT_EQ(parse_las_choice("255", "").listed.count(), 1u);
  for (const char* const classes : {"ground", "2,", ",2", "256", "-1", "2 9", "2,,9", "+2"})
    EXPECT_NE(message_of<ParameterError>([&] {
                parse_las_choice(classes, "");
              }).find("--las-class takes numbers"),
              std::string::npos)
        << classes;
  EXPECT_EQ(message_of<ParameterError>([] { parse_las_choice("", "only"); }),
            "--las-return takes first, last or all, and 'only' is none of them");
}

TEST(Las, CountOfLas14GoesBeforeTheOldOne) {
  LasWriter writer = writer_of({1, 4});
  writer.legacy_count_is_off_by = 5;
  EXPECT_EQ(read_las(input_of(writer.bytes())).counts.total, 24u);
}

// --- the coordinate system ---

std::string geo_keys(std::initializer_list<std::array<int, 4>> keys) {
  std::string bytes;
  const auto put = [&](int number) {
    bytes += static_cast<char>(number & 255);
    bytes += static_cast<char>(number >> 8);
  };
  for (const int number : {1, 1, 0, int(keys.size())}) put(number);
  for (const auto& key : keys)
    for (const int number : key) put(number);
  return bytes;
}

std::string crs_with(bool prefers_wkt, const std::string& keys, const std::string& wkt,
                     bool in_long_records = false) {
  LasWriter writer = writer_of({6, 4});
  writer.global_encoding = prefers_wkt ? 16 : 0;
  writer.in_long_records = in_long_records;
  if (!keys.empty()) writer.add_record("LASF_Projection", 34735, keys);
  writer.add_record("somebody", 2112, "PROJCS[]");
  if (!wkt.empty()) writer.add_record("LASF_Projection", 2112, wkt + std::string(2, '\0'));
  return read_las(input_of(writer.bytes())).points.crs;
}

constexpr const char* kWkt =
    "PROJCS[\"ETRS89 / \"\"UTM\"\" [zone] 32N\",GEOGCS[\"ETRS89\",AUTHORITY[\"EPSG\",\"4258\"]],"
    "UNIT[\"metre\",1,AUTHORITY[\"EPSG\",\"9001\"]],AUTHORITY[\"EPSG\",\"25832\"]]";

TEST(LasCrs, IsTheCodeOfTheWholeSystem) {
  EXPECT_EQ(las::epsg_code_in_wkt(kWkt), "25832");
  EXPECT_EQ(las::epsg_code_in_wkt("PROJCRS[\"a\",\n  BASEGEOGCRS[\"b\", ID[\"EPSG\",4258]],\n"
                                  "  ID[\"EPSG\", 25832]]"),
            "25832");
  EXPECT_EQ(las::epsg_code_in_wkt("PROJCS(\"a\",AUTHORITY(\"EPSG\",\"1\"))"), "1");
  EXPECT_EQ(las::epsg_code_in_wkt("PROJCS[\"a\",GEOGCS[\"b\",AUTHORITY[\"EPSG\",\"4258\"]]]"), "");
  EXPECT_EQ(las::epsg_code_in_wkt("PROJCS[\"a\",AUTHORITY[\"ESRI\",\"102003\"]]"), "");
  for (const char* const broken : {"", "\"", "[", "]]]]", "A[B[\"EPSG", "A[ID[", "A[ID[\"EPSG\""})
    EXPECT_EQ(las::epsg_code_in_wkt(broken), "") << broken;
}

TEST(LasCrs, ComesFromKeysOrText) {
  const std::string keys = geo_keys({{1024, 0, 1, 1}, {3072, 0, 1, 25833}});
  EXPECT_EQ(crs_with(false, keys, ""), "EPSG:25833");
  EXPECT_EQ(crs_with(false, keys, kWkt), "EPSG:25833");
  EXPECT_EQ(crs_with(true, keys, kWkt), "EPSG:25832");
  EXPECT_EQ(crs_with(true, keys, ""), "EPSG:25833");
  EXPECT_EQ(crs_with(false, "", kWkt), "EPSG:25832");
  EXPECT_EQ(crs_with(false, "", kWkt, true), "EPSG:25832");
  EXPECT_EQ(crs_with(true, "", "PROJCS[\"mine\"]"), "PROJCS[\"mine\"]");
  EXPECT_EQ(crs_with(true, "", ""), "");
  EXPECT_EQ(crs_with(false, geo_keys({{2048, 0, 1, 4326}}), ""), "EPSG:4326");
  EXPECT_EQ(crs_with(false, geo_keys({{2048, 0, 1, 4326}, {3072, 0, 1, 32767}}), ""), "")
      << "a projection of the user's own";
  EXPECT_EQ(crs_with(false, "cut", ""), "");
}

PointTable table_with(const std::string& keys, bool prefers_wkt = false) {
  LasWriter writer = writer_of({6, 4});
  writer.global_encoding = prefers_wkt ? 16 : 0;
  writer.add_record("LASF_Projection", 34735, keys);
  if (prefers_wkt) writer.add_record("LASF_Projection", 2112, kWkt + std::string(1, '\0'));
  return read_las_table(input_of(writer.bytes()), {});
}

/// Keys of x and y, heights, and the heights' unit; 0 for one that is not there.
std::string keys_of(int projected, int heights, int unit) {
  return geo_keys(
      {{1024, 0, 1, 1}, {3072, 0, 1, projected}, {4096, 0, 1, heights}, {4099, 0, 1, unit}});
}

TEST(LasCrs, HasTheSystemOfHeights) {
  if (!has_gdal()) GTEST_SKIP() << "built without GDAL";
  struct Case {
    int projected, heights, unit;
    const char* same;
  };
  for (const Case& c :
       {Case{25832, 7837, 9001, "EPSG:25832+7837"}, Case{25832, 7837, 0, "EPSG:25832+7837"},
        Case{2277, 5703, 9001, "EPSG:2277+5703"},
        // The numbers of GeoTIFF 1.0, and the unit beside.
        Case{2277, 5703, 9003, "EPSG:2277+6360"}, Case{2277, 5103, 9003, "EPSG:2277+6360"},
        Case{2277, 5103, 9002, "EPSG:2277+8228"}, Case{2277, 5103, 9001, "EPSG:2277+5703"},
        Case{2277, 5102, 9003, "EPSG:2277+5702"}, Case{25832, 32767, 32767, "EPSG:25832"},
        Case{25832, 0, 9001, "EPSG:25832"}, Case{2277, 0, 9003, "EPSG:2277"}}) {
    const PointTable table = table_with(keys_of(c.projected, c.heights, c.unit));
    EXPECT_EQ(table.points.crs, parse_crs("--crs", c.same));
    EXPECT_EQ(table.height_unit.metres != 0, c.unit == 9001 || c.unit == 9002 || c.unit == 9003);
    EXPECT_TRUE(table.warnings.empty()) << c.same << ": " << table.warnings[0];
  }
  EXPECT_EQ(table_with(keys_of(25833, 7837, 9001), true).points.crs, "EPSG:25832") << "by its text";
}

TEST(LasCrs, HasTheUnitOfHeights) {
  EXPECT_EQ(table_with(keys_of(25832, 0, 9002)).height_unit.metres, 0.3048);
  EXPECT_EQ(table_with(keys_of(25832, 0, 9001)).height_unit.metres, 1);
  EXPECT_EQ(table_with(keys_of(25832, 7837, 0)).height_unit.metres, 0);
}

TEST(LasCrs, SaysWhatOfHeightsIsNotKept) {
  const auto warnings_of = [](int projected, int heights, int unit) {
    const PointTable table = table_with(keys_of(projected, heights, unit));
    EXPECT_EQ(table.points.crs, "EPSG:" + std::to_string(projected));
    return fmt::format("{}", fmt::join(table.warnings, "\n"));
  };
  const auto expect_in = [](const std::string& all, const std::string& part) {
    EXPECT_NE(all.find(part), std::string::npos) << all;
  };
  if (!has_gdal()) {
    expect_in(warnings_of(25832, 7837, 9001), "7837");
    return;
  }
  expect_in(warnings_of(25832, 0, 9003), "heights are in US survey foot");
  expect_in(warnings_of(2277, 0, 9001), "heights are in metre");
  expect_in(warnings_of(25832, 5030, 0), "system 5030 (GeoKey 4096), which is not kept");
  expect_in(warnings_of(25832, 25832, 9001), "system 25832 (GeoKey 4096) in metre");
  const std::string two = warnings_of(25832, 7837, 9002);
  expect_in(two, "heights are in foot");
  expect_in(two, "system 7837 (GeoKey 4096) in foot, which is not kept");
}

// --- compressed files ---

std::vector<std::filesystem::path> fixtures() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(HODT_TEST_FILES) / "las"))
    if (entry.path().extension() == ".laz") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// "las/1_variable.laz" has the points of "las/1.las".
std::filesystem::path twin_of(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  return file.parent_path() / (stem.substr(0, stem.find('_')) + ".las");
}

auto content_of(const LasPoints& las) {
  const LasCounts& c = las.counts;
  return std::tuple(las.points.xy, las.points.z, las.points.crs, c.total, c.withheld, c.other_class,
                    c.other_return, c.of_class, c.taken_of_class);
}

TEST(Laz, HasThePointsOfItsTwin) {
  ASSERT_EQ(fixtures().size(), 17u);
  for (const std::filesystem::path& file : fixtures()) {
    SCOPED_TRACE(file);
    const InputText packed = read_input(file), plain = read_input(twin_of(file));
    for (const auto& [classes, returns] :
         {std::pair("", ""), {"all", ""}, {"all", "first"}, {"2,5", "last"}}) {
      const LasChoice choice = parse_las_choice(classes, returns);
      const auto wanted = content_of(read_las(plain, choice));
      EXPECT_EQ(content_of(read_las(packed, choice)), wanted);
      const ThreadLimit limit(1);
      EXPECT_EQ(content_of(read_las(packed, choice)), wanted);
    }
  }
}

TEST(Laz, IsKnownByItsBytesAndMayBePackedAgain) {
  const test::TemporaryDirectory directory;
  const std::filesystem::path file = std::filesystem::path(HODT_TEST_FILES) / "las" / "7.laz";
  const PointTable wanted = read_point_table(file);
  ASSERT_TRUE(wanted.columns.las);
  std::filesystem::copy(file, directory / "points.csv");
  EXPECT_EQ(read_points(directory / "points.csv").xy, wanted.points.xy);
}

}  // namespace
}  // namespace hodt
