// Every format that meshes are written in: what it keeps, and what happens if it cannot be written.
// What other programs read from the files is in read_back_test.cpp.
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "ogr.h"
#include "sample_tins.h"
#include "temporary_directory.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"
#include "hodt/io/formats.h"
#include "hodt/io/local_frame.h"
#include "hodt/io/tin_file.h"
#include "hodt/io/tin_parts.h"

namespace hodt {
namespace {

using test::content_of;
using test::message_of;
using test::TemporaryDirectory;

const std::string kName = "terr\xc3\xa4n 1";

/// A shapefile is several files; its bytes are those of all.
std::string bytes_in(const TemporaryDirectory& directory, const std::string& extension) {
  if (extension != ".shp") {
    EXPECT_EQ(directory.entries(), 1u);
    return content_of(directory / (kName + extension));
  }
  std::string bytes;
  for (const char* each : {".shp", ".shx", ".dbf", ".cpg", ".prj"})
    bytes += content_of(directory / (kName + each));
  return bytes;
}

std::string bytes_of(const Tin& tin, const std::string& extension) {
  const TemporaryDirectory directory;
  write_tin(tin, directory / (kName + extension));
  return bytes_in(directory, extension);
}

template <class T>
T number_at(std::string_view bytes, std::size_t offset) {
  T value;
  EXPECT_LE(offset + sizeof value, bytes.size());
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

class Writers : public testing::TestWithParam<const Format*> {
 protected:
  std::string extension_ = test::first_extension(*GetParam());
  const Keeps& keeps_ = GetParam()->keeps;

  void SetUp() override {
    if (!test::writes(extension_)) GTEST_SKIP() << "built without GDAL";
  }
  std::string bytes(const Tin& tin) const { return bytes_of(tin, extension_); }
};

// ---- The table of formats says the truth ----

/// If anything is kept, files of what differs only in that differ; and else they do not.
TEST_P(Writers, KeepWhatTheTableSays) {
  const Tin tin = test::survey(100);
  const std::string before = bytes(tin);
  const auto differs = [&](const auto& change) {
    Tin changed = tin;
    change(changed);
    return bytes(changed) != before;
  };
  EXPECT_EQ(differs([](Tin& t) { t.crs = "EPSG:2056"; }), keeps_.crs);
  EXPECT_EQ(differs([](Tin& t) { t.crs.clear(); }), keeps_.crs);
  // What these know is the code at the text's end, which is the same system.
  if (extension_ != ".fgb" && extension_ != ".shp" && extension_ != ".geojson") {
    EXPECT_EQ(differs([](Tin& t) { t.crs = test::wkt(); }), keeps_.crs);
  }
  EXPECT_EQ(differs([](Tin& t) { t.order.clear(); }), keeps_.order);
  EXPECT_EQ(differs([](Tin& t) { t.order[17] += 1; }), keeps_.order);
  const auto nudge = [](double& value) { value = std::nextafter(value, 1e300); };
  EXPECT_EQ(differs([&](Tin& t) { nudge(t.points.z[17]); }), keeps_.heights);
  EXPECT_EQ(differs([&](Tin& t) { nudge(t.points.xy[17].x); }), keeps_.heights);
  EXPECT_EQ(differs([&](Tin& t) { nudge(t.points.xy[17].y); }), keeps_.heights);
  EXPECT_TRUE(differs([](Tin& t) { std::swap(t.triangles[3], t.triangles[4]); }));
  EXPECT_TRUE(differs([](Tin& t) { t.points.z[17] += 1; }));
}

TEST_P(Writers, DoNotDependOnThreads) {
  const Tin tin = test::survey(30000);
  std::set<std::string> all;
  for (const std::size_t threads : {1, 2}) {
    const ThreadLimit limit(threads);
    all.insert(bytes(tin));
  }
  EXPECT_EQ(all.size(), 1u);
}

TEST_P(Writers, TakeWhateverMeshes) {
  for (Tin tin : {test::plain_triangle(), test::survey(4, test::wkt())}) {
    EXPECT_FALSE(bytes(tin).empty());
    tin.crs = "a\nb \"<&>\" \x01\xff--";
    EXPECT_FALSE(bytes(tin).empty());
  }
  if (keeps_.heights) {
    EXPECT_FALSE(bytes(test::extreme()).empty());
  } else {
    const TemporaryDirectory directory;
    const std::string message =
        message_of<InputError>([&] { write_tin(test::extreme(), directory / ("a" + extension_)); });
    EXPECT_NE(message.find("write .ply"), std::string::npos) << message;
    EXPECT_EQ(directory.entries(), 0u);
  }
}

TEST_P(Writers, ReplaceAFileOrLeaveIt) {
  const TemporaryDirectory directory;
  const Tin tin = test::survey(2000);
  const auto path = directory.file(kName + extension_, "before");
  rlimit limit;
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit full = {20000, limit.rlim_max};  // as good as a full disk
  ::setrlimit(RLIMIT_FSIZE, &full);
  EXPECT_THROW(write_tin(tin, path), FileError);
  EXPECT_THROW(write_tin(tin, directory / ("new" + extension_)), FileError);
  ::setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(content_of(path), "before");
  EXPECT_EQ(directory.entries(), 1u);
  EXPECT_THROW(write_tin(tin, directory / "none" / ("new" + extension_)), FileError);
  EXPECT_THROW(write_tin(tin, "/proc/new" + extension_), FileError);
  std::filesystem::create_symlink("/dev/full", directory / ("full" + extension_));
  const std::string message =
      message_of<Error>([&] { write_tin(tin, directory / ("full" + extension_)); });
  EXPECT_NE(message.find(extension_ == ".shp" ? "several files" : "No space left"),
            std::string::npos)
      << message;
  std::filesystem::remove(directory / ("full" + extension_));
  write_tin(tin, path);
  EXPECT_TRUE(bytes_in(directory, extension_) == bytes(tin));
}

INSTANTIATE_TEST_SUITE_P(All, Writers, testing::ValuesIn(test::mesh_formats()),
                         [](const auto& each) {
                           return test::first_extension(*each.param).substr(1);
                         });

// ---- The files themselves ----

Tin small() {
  return {{{{512000.1, 5403000}, {512010, 5403000.25}, {512000, 5403020}}, {1.5, -2, 0.1}},
          {{0, 1, 2}},
          "EPSG:25832",
          {3}};
}

TEST(TwoDm, IsLinesOfElementsAndNodes) {
  EXPECT_EQ(bytes_of(small(), ".2dm"),
            "MESH2D\nE3T 1 1 2 3 1\nND 1 512000.1 5403000 1.5\nND 2 512010 5403000.25 -2\n"
            "ND 3 512000 5403020 0.1\n");
  EXPECT_NE(bytes_of(test::plain_triangle(), ".2dm").find("\nND 3 0 1 0\n"), std::string::npos);
}

TEST(LandXml, HasNorthingsFirst) {
  const std::string text = bytes_of(small(), ".xml");
  EXPECT_EQ(text, bytes_of(small(), ".landxml"));
  EXPECT_NE(text.find("<Pnts>\n<P id=\"1\">5403000 512000.1 1.5</P>\n"
                      "<P id=\"2\">5403000.25 512010 -2</P>\n"
                      "<P id=\"3\">5403020 512000 0.1</P>\n</Pnts>\n"
                      "<Faces>\n<F>1 2 3</F>\n</Faces>\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("<CoordinateSystem name=\"EPSG:25832\" epsgCode=\"25832\"/>"),
            std::string::npos);
  Tin tin = small();
  tin.crs = test::wkt();
  EXPECT_NE(
      bytes_of(tin, ".xml")
          .find("<CoordinateSystem ogcWktCode=\"PROJCRS[&#34;ETRS89 / &#60;UTM&#62; &#38; "
                "\xc3\xb6stlich&#34;,&#10;    ID[&#34;EPSG&#34;,25832]]\" epsgCode=\"25832\"/>"),
      std::string::npos);
}

TEST(LandXml, HasTheUnitOfTheSystem) {
  const auto units = [](const std::string& crs) {
    Tin tin = small();
    tin.crs = crs;
    const std::string text = bytes_of(tin, ".xml");
    const std::size_t begin = text.find("<Units>");
    return begin == text.npos ? "" : text.substr(begin, text.find("</Units>") - begin);
  };
  const std::string metres =
      "<Units><Metric areaUnit=\"squareMeter\" linearUnit=\"meter\" volumeUnit=\"cubicMeter\" "
      "temperatureUnit=\"celsius\" pressureUnit=\"milliBars\"/>";
  EXPECT_EQ(units(""), metres) << "nothing is known";
  EXPECT_EQ(units("EPSG:25832"), metres);
  if (!has_gdal()) return;
  EXPECT_EQ(units("EPSG:2225"),
            "<Units><Imperial areaUnit=\"squareFoot\" linearUnit=\"USSurveyFoot\" "
            "volumeUnit=\"cubicFeet\" temperatureUnit=\"fahrenheit\" pressureUnit=\"inHG\"/>");
  EXPECT_NE(units("EPSG:2222").find("linearUnit=\"foot\""), std::string::npos) << "Arizona";
  EXPECT_EQ(units("EPSG:2225+6360").find("elevationUnit"), std::string::npos);
  EXPECT_NE(units("EPSG:2225+5703").find("elevationUnit=\"meter\"/>"), std::string::npos);
  EXPECT_NE(units("EPSG:25832+8228").find("elevationUnit=\"feet\"/>"), std::string::npos);
  EXPECT_EQ(units("EPSG:4326"), "") << "degrees are no lengths";
  EXPECT_EQ(units("EPSG:2314"), "") << "Clarke's foot";
}

TEST(Stl, TellsItsOriginAndRoundsFromThere) {
  const std::string bytes = bytes_of(small(), ".stl");
  ASSERT_EQ(bytes.size(), 84 + 50u);
  EXPECT_TRUE(bytes.starts_with("hodt, coordinates from 512005 5403010 0 ")) << bytes.substr(0, 80);
  EXPECT_EQ(number_at<std::uint32_t>(bytes, 80), 1u);
  const float expected[] = {float(512000.1 - 512005), -10, 1.5f, 5, -9.75f, -2, -5, 10, 0.1f};
  for (std::size_t i = 0; i < 9; ++i)
    EXPECT_EQ(number_at<float>(bytes, 96 + 4 * i), expected[i]) << i;
  double length = 0;
  for (std::size_t i = 0; i < 3; ++i) length += std::pow(number_at<float>(bytes, 84 + 4 * i), 2);
  EXPECT_NEAR(length, 1, 1e-6);
  EXPECT_GT(number_at<float>(bytes, 92), 0) << "up";
}

TEST(Glb, TurnsAxesAndAddsTheOrigin) {
  const std::string bytes = bytes_of(small(), ".glb");
  EXPECT_EQ(number_at<std::uint32_t>(bytes, 8), bytes.size());
  const auto length = number_at<std::uint32_t>(bytes, 12);
  const auto json = nlohmann::json::parse(bytes.substr(20, length));
  const auto& node = json["nodes"][0];
  EXPECT_EQ(node["translation"], nlohmann::json({512005, 0, -5403010}));
  EXPECT_EQ(node["extras"]["origin"], nlohmann::json({512005, 5403010, 0}));
  EXPECT_EQ(node["extras"]["crs"], "EPSG:25832");
  const std::size_t binary = 20 + length + 8;
  EXPECT_EQ(number_at<float>(bytes, binary), float(512000.1 - 512005));
  EXPECT_EQ(number_at<float>(bytes, binary + 4), 1.5f);
  EXPECT_EQ(number_at<float>(bytes, binary + 8), 10) << "south";
  for (Index i = 0; i < 3; ++i)
    EXPECT_EQ(number_at<Index>(bytes, binary + 36 + 4 * std::size_t{i}), i);
  EXPECT_EQ(bytes.size(), binary + 48);
}

TEST(Vtu, HasRawNumbersWhereItSays) {
  const std::string bytes = bytes_of(small(), ".vtu");
  const std::size_t begin = bytes.find("<AppendedData encoding=\"raw\">\n_") + 31;
  const auto array = [&](const std::string& name) {
    const std::size_t at = bytes.find("Name=\"" + name + "\"");
    const std::size_t offset = bytes.find("offset=\"", at) + 8;
    return begin + std::stoul(bytes.substr(offset));
  };
  EXPECT_EQ(number_at<std::uint64_t>(bytes, array("Points")), 72u);
  EXPECT_EQ(number_at<double>(bytes, array("Points") + 8), 512000.1);
  EXPECT_EQ(number_at<double>(bytes, array("Points") + 8 + 64), 0.1);
  EXPECT_EQ(number_at<std::int64_t>(bytes, array("connectivity") + 8 + 16), 2);
  EXPECT_EQ(number_at<std::int64_t>(bytes, array("offsets") + 8), 3);
  EXPECT_EQ(number_at<std::uint8_t>(bytes, array("types") + 8), 5);
  EXPECT_EQ(number_at<double>(bytes, array("z") + 8), 1.5);
  EXPECT_EQ(number_at<std::uint32_t>(bytes, array("order") + 8), 3u);
  EXPECT_EQ(number_at<std::uint8_t>(bytes, array("changed") + 8), 1);
}

TEST(Ply, IsReadWithItsReferenceSystem) {
  const TemporaryDirectory directory;
  const Tin tin = test::survey(500, test::wkt());
  write_tin(tin, directory / "a.ply");
  const Tin read = read_tin(directory / "a.ply");
  EXPECT_EQ(read.triangles, tin.triangles);
  EXPECT_EQ(read.points.xy, tin.points.xy);
  EXPECT_EQ(read.points.z, tin.points.z);
  EXPECT_EQ(read.crs, "PROJCRS[\"ETRS89 / <UTM> & ?stlich\",ID[\"EPSG\",25832]]");
  write_tin(tin, directory / "a.obj");
  EXPECT_EQ(read_tin(directory / "a.obj").crs, in_one_line(tin.crs));
}

TEST(LocalFrame, KnowsHowFarItIsOff) {
  const Tin tin = test::survey(1000);
  const LocalFrame frame(tin);
  double largest = 0;
  for (std::size_t i = 0; i < tin.points.size(); ++i) {
    const std::array<double, 3> exact = {tin.points.xy[i].x, tin.points.xy[i].y, tin.points.z[i]};
    for (std::size_t k = 0; k < 3; ++k)
      largest = std::max(largest, std::fabs(exact[k] - (frame.origin()[k] + double{frame[i][k]})));
  }
  EXPECT_GE(frame.largest_error(), largest);
  EXPECT_LT(frame.largest_error(), 1e-4);
  EXPECT_EQ(LocalFrame(test::plain_triangle()).largest_error(), 0);
}

TEST(TinParts, EscapeAttributes) {
  EXPECT_EQ(xml_attribute("a\"<&>\n\x01\xff\xc3\xb6\xef\xbf\xbf'"),
            "a&#34;&#60;&#38;&#62;&#10;\xc3\xb6'");
}

TEST(TinParts, UnderstandReferenceSystems) {
  EXPECT_EQ(epsg_code("EPSG:25832"), 25832);
  EXPECT_EQ(epsg_code(test::wkt()), 25832);
  for (const char* other : {"", "EPSG:", "EPSG:x", "EPSG:1x", "EPSG:-4", "EPSG:99999999999",
                            "ESRI:102008", "PROJCRS[\"EPSG:25832\"]"})
    EXPECT_FALSE(epsg_code(other)) << other;
  EXPECT_EQ(in_one_line("a\r\n   b c\n"), "ab c");
}

}  // namespace
}  // namespace hodt
