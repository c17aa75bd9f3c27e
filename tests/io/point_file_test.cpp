#include "hodt/io/point_file.h"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "temporary_directory.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"
#include "hodt/io/gzip.h"
#include "hodt/io/system_file_error.h"

namespace hodt {
namespace {

using test::message_of;
using test::TemporaryDirectory;

class PointFile : public testing::Test {
 protected:
  PointSet read(std::string_view content, std::string_view name = "points.csv") const {
    return read_points(directory_.file(name, content));
  }
  std::string error(std::string_view content) const {
    return message_of<InputError>([&] { read(content); });
  }
  static std::string packed(std::string_view text) {
    const Buffer<char> bytes = gzip(text);
    return {bytes.data(), bytes.size()};
  }

  TemporaryDirectory directory_;
};

void expect_three(const PointSet& points) {
  EXPECT_EQ(points.xy, (std::vector<Point>{{1, 2}, {4, 5}, {7.5, -8}}));
  EXPECT_EQ(points.z, (std::vector<double>{3, 6, 1e3}));
}

TEST_F(PointFile, ReadsEveryDialect) {
  expect_three(read("1,2,3\n4,5,6\n7.5,-8,1e3\n"));
  expect_three(read("x,y,z\n1,2,3\n4,5,6\n7.5,-8,1e3"));
  expect_three(read("x;y;z\r\n1;2;3\r\n4;5;6\r\n7.5;-8;1e3\r\n"));
  expect_three(read("x\ty\tz\n1\t2\t3\n4\t5\t6\n7.5\t-8\t1e3\n"));
  expect_three(read("1 2 3\n  4   5\t6 \n7.5 -8 1e3\n"));
  expect_three(read("x y z\n1 2 3\n4 5 6\n7.5 -8 1e3\n"));
  expect_three(read("1, 2, 3\n4 ,5 ,6\n 7.5,\t-8,1e3 \n"));
  expect_three(read("\xEF\xBB\xBFx,y,z\n1,2,3\n4,5,6\n7.5,-8,1e3\n"));
  expect_three(read("\"x\",\"y\",\"z\"\n\"1\",\"2\",\"3\"\n4,\"5\",6\n7.5,-8,1e3\n"));
}

TEST_F(PointFile, SkipsBlankLinesAndComments) {
  expect_three(read("# made by hand\n\nx,y,z\n1,2,3\n\n# and\n4,5,6\n   \n,,\n7.5,-8,1e3\n\n\n"));
}

TEST_F(PointFile, FindsColumnsByName) {
  expect_three(read("id,Z,name,Y,X\n1,3,a,2,1\n2,6,\"b,c\",5,4\n3,1e3,,-8,7.5\n"));
  expect_three(read("Easting;Northing;Elevation [m]\n1;2;3\n4;5;6\n7.5;-8;1e3\n"));
  expect_three(read("lat,lon,height\n2,1,3\n5,4,6\n-8,7.5,1e3\n"));
  expect_three(read("lon,lat,x,y,z\n0,0,1,2,3\n0,0,4,5,6\n0,0,7.5,-8,1e3\n"));
  expect_three(read("V1,V2,V3\n1,2,3\n4,5,6\n7.5,-8,1e3\n"));
  expect_three(read("x,y,z,remark\n1,2,3,a\n4,5,6\n7.5,-8,1e3,\n"));
}

TEST_F(PointFile, TwoColumnsHaveNoHeights) {
  for (const char* text :
       {"1,2\n3,4\n", "x y\n1 2\n3 4\n", "x,y,\n1,2,\n3,4,\n", "y,id,x\n2,7,1\n4,7,3\n"}) {
    const PointSet points = read(text);
    EXPECT_EQ(points.xy, (std::vector<Point>{{1, 2}, {3, 4}})) << text;
    EXPECT_FALSE(points.has_heights());
  }
}

TEST_F(PointFile, UnpacksGzip) {
  const std::string text = "1,2,3\n4,5,6\n7.5,-8,1e3\n";
  expect_three(read(packed(text)));
  // Several members, cut anywhere, and the zeros of a tape block.
  expect_three(read(packed(text.substr(0, 8)) + packed("") + packed(text.substr(8))));
  expect_three(read(packed(text) + std::string(512, '\0')));
}

TEST_F(PointFile, ReportsDamagedGzip) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += std::to_string(i * i) + ",2,3\n";
  const std::string whole = packed(text);
  for (const std::size_t size :
       {std::size_t{2}, std::size_t{12}, whole.size() / 2, whole.size() - 1}) {
    EXPECT_NE(error(whole.substr(0, size)).find("cut short"), std::string::npos) << size;
  }
  std::string flipped = whole;
  flipped[whole.size() / 2] ^= 1;
  EXPECT_NE(error(flipped).find("gzip"), std::string::npos);
  EXPECT_NE(error(whole + "more").find("gzip"), std::string::npos);
}

TEST_F(PointFile, NamesFileLineAndProblem) {
  struct Case {
    const char* content;
    const char* line;
    const char* problem;
  };
  const Case cases[] = {
      {"x,y,z\n1,2,3\n1,nan,3\n", "points.csv, line 3:", "'nan'"},
      {"1,2,3\n1,2,-inf\n", "line 2:", "'-inf'"},
      {"1,2,3\n1e999,2,3\n", "line 2:", "'1e999'"},
      {"nan,2,3\n", "line 1:", "'nan'"},
      {"# c\n\n1,2,3\n4,5\n", "line 4:", "no value for z"},
      {"1,2,3\n,5,6\n", "line 2:", "no value for x"},
      {"1,2,3\n4,,6\n", "line 2:", "no value for y"},
      {"1 2 3\n4\n", "line 2:", "no value for y"},
      {"1,2,3\n4,abc,6\n", "line 2:", "'abc'"},
      {"1,2,3\n4,0x10,6\n", "line 2:", "'0x10'"},
      {"1,2,3\n4,5 5,6\n", "line 2:", "'5 5'"},
      {"1;2.5;3\n4;5,5;6\n", "line 1:", "decimal point"},
      {"x,y,z\nA,2,3\n", "line 2:", "'A'"},
      {"1,2,abc\n", "line 1:", "'abc'"},
      {"1,2\n3,4,5\n", "line 2:", "third value"},
      {"1,2,3\n4,\"5,6\n", "line 2:", ""},
      {"1\n2\n", "line 1:", "only one column"},
      {"x,height\n1,2\n", "line 1:", "name both x and y"},
      {"1,2,3\n4,aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa,6\n", "line 2:", "aaa...'"},
  };
  for (const Case& c : cases) {
    const std::string message = error(c.content);
    EXPECT_NE(message.find(c.line), std::string::npos) << message;
    EXPECT_NE(message.find(c.problem), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST_F(PointFile, ReportsFilesWithoutPoints) {
  EXPECT_NE(error("").find("points.csv is empty"), std::string::npos);
  for (const char* content : {"x,y,z\n", "# nothing\n", "\n\n", "\xEF\xBB\xBF\n"}) {
    EXPECT_NE(error(content).find("no data row"), std::string::npos) << content;
  }
  EXPECT_NE(error(std::string("1,2,3\n\0\1\2", 9)).find("binary"), std::string::npos);
  EXPECT_NE(error(std::string("\xFF\xFE\n\0", 4)).find("no data row"), std::string::npos);
}

TEST_F(PointFile, ReportsUnreadablePaths) {
  const auto why = [](const std::filesystem::path& path) {
    return message_of<FileError>([&] { read_points(path); });
  };
  EXPECT_NE(why(directory_ / "none.csv").find("none.csv: No such file"), std::string::npos);
  for (const auto& [name, number] : {std::pair{"none.csv", ENOENT}, std::pair{"", EISDIR}}) try {
      read_points(directory_ / name);
      FAIL() << name;
    } catch (const SystemFileError& error) {
      EXPECT_EQ(error.number(), number);
      EXPECT_EQ(error.file(), directory_ / name);
    }
  EXPECT_NE(why(directory_.path()).find("directory"), std::string::npos);
}

std::string many_rows(std::size_t count) {
  std::mt19937 random(3);
  std::string text = "x,y,z\n";
  for (std::size_t i = 0; i < count; ++i) {
    text += std::to_string(random() / 1e3) + "," + std::to_string(random() / 7.0) + "," +
            std::to_string(i) + "\n";
    if (random() % 100 == 0) text += "# a comment that leaves a gap\n\n";
  }
  return text;
}

TEST_F(PointFile, KeepsTheOrderOnAnyThreadCount) {
  constexpr std::size_t count = 100000;
  const std::string text = many_rows(count);
  const ThreadLimit one(1);
  const PointSet alone = read(text);
  ASSERT_EQ(alone.size(), count);
  for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(alone.z[i], static_cast<double>(i));
  for (const std::size_t threads : {2, 7}) {
    const ThreadLimit limit(threads);
    const PointSet together = read(text);
    EXPECT_EQ(alone.xy, together.xy);
    EXPECT_EQ(alone.z, together.z);
  }
}

TEST_F(PointFile, NamesTheFirstBadLineOfMany) {
  std::string text = many_rows(100000);
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  text += "1,2,first\n" + many_rows(100000).substr(6) + "1,2,second\n";
  const std::string message = error(text);
  EXPECT_NE(message.find("line " + std::to_string(lines + 1) + ":"), std::string::npos) << message;
  EXPECT_NE(message.find("'first'"), std::string::npos) << message;
}

PointSet any_doubles(std::size_t count, bool heights) {
  std::mt19937_64 random(4);
  const auto next = [&] {
    for (;;) {
      const double value = std::bit_cast<double>(random());
      if (std::isfinite(value)) return value;
    }
  };
  PointSet points;
  for (std::size_t i = 0; i < count; ++i) {
    points.xy.push_back({next(), next()});
    if (heights) points.z.push_back(next());
  }
  return points;
}

TEST_F(PointFile, RoundTripsBitForBit) {
  for (const char* name : {"a.csv", "a.csv.gz", "a.xyz", "a.XYZ.gz"}) {
    for (const bool heights : {true, false}) {
      const PointSet points = any_doubles(20000, heights);
      write_points(points, directory_ / name);
      const PointSet back = read_points(directory_ / name);
      EXPECT_EQ(points.xy, back.xy) << name;
      EXPECT_EQ(points.z, back.z) << name;
    }
  }
  EXPECT_THROW(write_points({}, directory_ / "a.shp"), ParameterError);
  EXPECT_THROW(check_points_extension("a"), ParameterError);
  EXPECT_NO_THROW(check_points_extension("-"));
}

}  // namespace
}  // namespace hodt
