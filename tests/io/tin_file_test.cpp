#include "hodt/io/tin_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "temporary_directory.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"

namespace hodt {
namespace {

using test::content_of;
using test::message_of;
using test::TemporaryDirectory;
using Triangles = std::vector<std::array<Index, 3>>;

class TinFile : public testing::Test {
 protected:
  Tin read(std::string_view name, std::string_view content) const {
    return read_tin(directory_.file(name, content));
  }
  std::string error(std::string_view name, std::string_view content) const {
    return message_of<InputError>([&] { read(name, content); });
  }

  TemporaryDirectory directory_;
};

void expect_square(const Tin& tin) {
  EXPECT_EQ(tin.points.xy, (std::vector<Point>{{0, 0}, {1, 0}, {1, 1.5}, {0, 1}}));
  EXPECT_EQ(tin.points.z, (std::vector<double>{5, 6, 7, 8}));
  EXPECT_EQ(tin.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

const std::string kVertices = "v 0 0 5\nv 1 0 6\nv 1 1.5 7\nv 0 1 8\n";

TEST_F(TinFile, ReadsObj) {
  expect_square(read("a.obj", kVertices + "f 1 2 3\nf 1 3 4\n"));
  expect_square(read("a.OBJ", kVertices + "f 1/1 2/2/2 3//3\r\nf -4 -2 -1\r\n"));
  expect_square(read("a.obj", "# text\no thing\nvn 0 0 1\nvt 0 0\nf 1 2 3\n" + kVertices +
                                  "s off\nusemtl m\n\n  f 1 3 4"));
  expect_square(read("a.obj",
                     "v 0 0 5 1 0 0\nv 1 0 6 1 0 0\nv 1 1.5 7 1 1 1\nv 0 1 8 0 0 0\n"
                     "f 1 2 3\nf 1 3 4\n"));
  EXPECT_EQ(read("a.obj", "# crs: EPSG:25832\n" + kVertices + "f 1 2 3\n").crs, "EPSG:25832");
  EXPECT_FALSE(read("a.obj", "v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n").points.has_heights());
}

TEST_F(TinFile, NamesTheLineOfABadObj) {
  struct Case {
    std::string content;
    const char* message;
  };
  const Case cases[] = {
      {kVertices + "f 1 2 5\n", "line 5: there is no vertex 5; the last is 4"},
      {kVertices + "f 1 2 0\n", "line 5: there is no vertex 0"},
      {kVertices + "f 1 2 -5\n", "line 5: there is no vertex -5"},
      {kVertices + "f 1 2\n", "line 5: a face needs three corners"},
      {kVertices + "f 1 2 3 4\n", "triangulate the mesh first"},
      {kVertices + "f 1 2 x\n", "line 5: 'x'"},
      {kVertices + "f 1 2 99999999999999999999999\n", "line 5: '99999999"},
      {"v 0 0 nan\n", "line 1: 'nan'"},
      {"v 0 0 0\nv 1 abc 0\n", "line 2: 'abc'"},
      {"v 0 0 0\nv 1 1e999 0\n", "line 2: '1e999'"},
      {"v 0 0 0\nv 1\n", "line 2: a vertex needs"},
      {"v 0 0 0\nv 1 2\n", "line 2: some vertices have heights"},
      {kVertices, "holds no triangle"},
      {"hello\n", "holds no vertex"},
      {"", "is empty"},
      {std::string("v 0 0 0\n\0", 9), "binary"},
  };
  for (const Case& c : cases) {
    const std::string message = error("bad.obj", c.content);
    EXPECT_NE(message.find(c.message), std::string::npos) << message;
    EXPECT_NE(message.find("bad.obj"), std::string::npos) << message;
  }
}

const std::string kPlyHeader =
    "element vertex 4\nproperty float x\nproperty double y\nproperty uchar red\n"
    "property list uchar short extra\nproperty int z\n"
    "element edge 1\nproperty int vertex1\n"
    "element face 2\nproperty list uchar int vertex_index\nproperty double quality\nend_header\n";

TEST_F(TinFile, ReadsTextPly) {
  expect_square(read("a.ply", "ply\nformat ascii 1.0\ncomment crs: EPSG:25832\n" + kPlyHeader +
                                  "0 0 9 0 5\n1 0 9 1 7 6\n1 1.5 9 2 7 7 7\n0 1 9 0 8\n"
                                  "77\n3 0 1 2 0.5\n3 0 2 3 0.5\n"));
  expect_square(read("b.ply",
                     "ply\r\nformat ascii 1.0\r\nelement vertex 4\r\nproperty float x\r\n"
                     "property float y\r\nproperty float z\r\nelement face 2\r\n"
                     "property list uchar int vertex_indices\r\nend_header\r\n"
                     "0 0 5\r\n1 0 6\r\n1 1.5 7\r\n0 1 8\r\n3 0 1 2\r\n3 0 2 3"));
}

/// The same file in binary.
class BinaryBody {
 public:
  explicit BinaryBody(bool big) : swap_(big != (std::endian::native == std::endian::big)) {}

  template <class T>
  void put(T value) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    if (swap_) std::reverse(bytes, bytes + sizeof(T));
    text_.append(bytes, sizeof(T));
  }
  void vertex(float x, double y, std::vector<std::int16_t> extra, std::int32_t z) {
    put(x);
    put(y);
    put(std::uint8_t{9});
    put(static_cast<std::uint8_t>(extra.size()));
    for (const auto e : extra) put(e);
    put(z);
  }
  void face(std::vector<std::int32_t> corners) {
    put(static_cast<std::uint8_t>(corners.size()));
    for (const auto c : corners) put(c);
    put(0.5);
  }
  const std::string& text() const { return text_; }

 private:
  bool swap_;
  std::string text_;
};

std::string binary_square(bool big) {
  BinaryBody body(big);
  body.vertex(0, 0, {}, 5);
  body.vertex(1, 0, {7}, 6);
  body.vertex(1, 1.5, {7, 7}, 7);
  body.vertex(0, 1, {}, 8);
  body.put(std::int32_t{77});
  body.face({0, 1, 2});
  body.face({0, 2, 3});
  return std::string("ply\nformat ") + (big ? "binary_big_endian" : "binary_little_endian") +
         " 1.0\n" + kPlyHeader + body.text();
}

TEST_F(TinFile, ReadsBinaryPlyOfBothByteOrders) {
  expect_square(read("a.ply", binary_square(false)));
  expect_square(read("a.ply", binary_square(true)));
}

TEST_F(TinFile, ReportsACutPly) {
  const std::string whole = binary_square(false);
  for (std::size_t size = 1; size < whole.size(); ++size) {
    EXPECT_NE(error("cut.ply", whole.substr(0, size)).find("cut.ply"), std::string::npos) << size;
  }
}

TEST_F(TinFile, NamesTheProblemOfABadPly) {
  const auto with = [](const std::string& body) {
    return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
           "element face 1\nproperty list uchar int vertex_indices\nend_header\n" +
           body;
  };
  struct Case {
    std::string content;
    const char* message;
  };
  const Case cases[] = {
      {with("0 0\n1 0\n0 1\n3 0 1 3\n"), "face 0: there is no vertex 3; the last is 2"},
      {with("0 0\n1 0\n0 1\n3 0 1 -1\n"), "face 0: there is no vertex -1"},
      {with("0 0\n1 0\n0 1\n3 0 1 1.5\n"), "face 0: there is no vertex 1.5"},
      {with("0 0\n1 0\n0 1\n4 0 1 2 2\n"), "triangulate the mesh first"},
      {with("0 0\n1 0\n0 1\n2 0 1\n"), "face 0: 2 corners"},
      {with("0 0\nnan 0\n0 1\n3 0 1 2\n"), "vertex 1: not a finite number"},
      {with("0 0\nabc 0\n0 1\n3 0 1 2\n"), "vertex 1: not a finite number"},
      {with("0 0\n1 0\n"), "vertex 2: the file ends here"},
      {"ply\nformat ascii 1.0\nelement vertex x\n", "line 3"},
      {"ply\nformat cuneiform 1.0\n", "line 2: unknown format 'cuneiform'"},
      {"ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\n", "line 4: unknown type 'quad'"},
      {"plyboy\n", "line 1"},
      {"", "is empty"},
  };
  for (const Case& c : cases) {
    const std::string message = error("bad.ply", c.content);
    EXPECT_NE(message.find(c.message), std::string::npos) << message;
    EXPECT_NE(message.find("bad.ply"), std::string::npos) << message;
  }
}

const std::string kTextHeader =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
const std::string kTextBody = "0 0 5\n1 0 6\n0 1 7\n3 0 1 2\n";

/// The text with the first `old` replaced.
std::string with(std::string text, std::string_view old, std::string_view replacement) {
  return text.replace(text.find(old), old.size(), replacement);
}

TEST_F(TinFile, ReadsPlyWithCapitalCoordinates) {
  const std::string header = with(with(with(kTextHeader, " x", " X"), " y", " Y"), " z", " Z");
  const Tin tin = read("a.ply", header + kTextBody);
  EXPECT_EQ(tin.points.xy, (std::vector<Point>{{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_EQ(tin.points.z, (std::vector<double>{5, 6, 7}));
}

TEST_F(TinFile, ReadsPlyWithLineEndsOfOldMacs) {
  std::string text = kTextHeader + kTextBody;
  std::replace(text.begin(), text.end(), '\n', '\r');
  for (const char* name : {"a.ply", "a"})
    EXPECT_EQ(read(name, text).points.z, (std::vector<double>{5, 6, 7}));
}

TEST_F(TinFile, RefusesPlyThatSaysAThingTwice) {
  struct Case {
    const char* old;
    const char* replacement;
    const char* message;
  };
  const Case cases[] = {
      // The second element had no z: fewer heights than points.
      {"element face", "element vertex 1\nproperty float x\nproperty float y\nelement face",
       "announces two elements 'vertex'"},
      {"end_header", "element face 0\nproperty list uchar int vertex_indices\nend_header",
       "announces two elements 'face'"},
      {"property float z", "property float x", "announces 'x' twice"},
      {"property float z", "property float z\nproperty float Z", "announces 'z' twice"},
      {"end_header", "property list uchar int vertex_index\nend_header",
       "announces 'vertex_indices' twice"},
      {"format ascii 1.0", "format ascii 1.0\nformat binary_big_endian 1.0",
       "line 3: a second format line"},
  };
  for (const Case& c : cases) {
    const std::string message = error("a.ply", with(kTextHeader, c.old, c.replacement) + kTextBody);
    EXPECT_NE(message.find(c.message), std::string::npos) << message;
  }
}

TEST_F(TinFile, RefusesPlyWhoseHeaderIsNotUnderstood) {
  struct Case {
    const char* old;
    const char* replacement;
    const char* message;
  };
  const Case cases[] = {
      {"vertex 3", "vertex -3", "line 3: '-3' is no count"},
      {"vertex 3", "vertex 0x3", "line 3: '0x3' is no count"},
      {"vertex 3", "vertex 3.0", "line 3: '3.0' is no count"},
      {"vertex 3", "vertex +3", "line 3: '+3' is no count"},
      {"vertex 3", "vertex 3 4", "line 3: '4' is one word too many"},
      {"vertex 3", "vertex 4294967295", "line 3: more elements"},
      {"vertex 3", "vertex 18446744073709551619", "line 3: more elements"},
      {"float x", "float x y", "line 4: 'y' is one word too many"},
      {"element vertex", "elment vertex", "line 3: 'elment'"},
      {"ascii 1.0", "ascii 2.0", "line 2: unknown version '2.0'"},
      {"ascii 1.0", "ascii", "line 2: unknown version ''"},
      {"float x", "list uchar float x", "'x' that is a list"},
      {"list uchar int vertex_indices", "int vertex_indices", "'vertex_indices' that is no list"},
  };
  for (const Case& c : cases) {
    const std::string message = error("a.ply", with(kTextHeader, c.old, c.replacement) + kTextBody);
    EXPECT_NE(message.find(c.message), std::string::npos) << message;
  }
}

TEST_F(TinFile, DoesNotBelieveWhatPlyAnnounces) {
  // Items without properties take no room: there may be four billion of them, in no time.
  const std::string nothing = "element nothing 4294967294\nelement face";
  EXPECT_EQ(read("a.ply", with(kTextHeader, "element face", nothing) + kTextBody).points.size(),
            3u);
  for (const char* count : {"4", "4294967294"}) {
    const std::string vertices = "vertex " + std::string(count);
    EXPECT_NE(error("a.ply", with(kTextHeader, "vertex 3", vertices) + "0 0 5\n1 0 6\n0 1 7\n")
                  .find("vertex 3: the file ends here"),
              std::string::npos);
    const std::string binary =
        with(with(kTextHeader, "ascii", "binary_little_endian"), "vertex 3", vertices);
    EXPECT_NE(error("a.ply", binary + std::string(36, '\1')).find("vertex 3: the file ends here"),
              std::string::npos);
  }
  // A list of four billion numbers.
  const std::string list =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\n"
      "property list uint uchar extra\nproperty float x\nproperty float y\n"
      "end_header\n\xfe\xff\xff\xff";
  EXPECT_NE(error("a.ply", list + std::string(99, '\1')).find("vertex 0: the file ends here"),
            std::string::npos);
}

TEST_F(TinFile, RefusesPlyThatGoesOnAfterItsEnd) {
  EXPECT_EQ(read("a.ply", kTextHeader + kTextBody + " \r\n\n").points.size(), 3u);
  for (const std::string rest : {"3 0 2 1\n", "x"})
    EXPECT_NE(error("a.ply", kTextHeader + kTextBody + rest).find("goes on after the last element"),
              std::string::npos);
  EXPECT_NE(error("a.ply", binary_square(false) + "\3").find("goes on after the last element"),
            std::string::npos);
}

TEST_F(TinFile, RefusesTextPlyWhoseRowsDoNotFit) {
  const auto of = [&](const std::string& body) { return error("a.ply", kTextHeader + body); };
  const std::string surplus = ": its line holds more numbers than the header announces";
  EXPECT_NE(of("0 0 5 255\n1 0 6 255\n0 1 7 255\n3 0 1 2\n").find("vertex 0" + surplus),
            std::string::npos);
  EXPECT_NE(of("0 0 5\n1 0\n0 1 7\n3 0 1 2\n").find("vertex 1" + surplus), std::string::npos);
  EXPECT_NE(of("0 0 5\n1 0 6\n0 1 7\n3 0 1 2 9\n").find("face 0" + surplus), std::string::npos);
}

TEST_F(TinFile, ContinuesObjLines) {
  const std::string expected = kVertices + "f 1 2 3\nf 1 3 4\n";
  expect_square(read("a.obj",
                     "v 0 0 \\\n5\nv \\\r\n1 0 6\nv 1 1.5 7 \\\n1 0 0\nv 0 1 8\\\n\n"
                     "f 1 \\\n \\\n2 3\nf 1/1\\\n 3/2/2 \\\n4//4\n"));
  // Paths end in backslashes, too: only vertices and faces go on.
  expect_square(read("a.obj", "mtllib C:\\mesh\\\n# in C:\\mesh\\\n" + expected));
  EXPECT_NE(error("a.obj", kVertices + "f 1 \\\n2 \\\n3 \\\n4\n").find("4 corners"),
            std::string::npos);
  EXPECT_NE(error("a.obj", kVertices + "f 1 \\\n2\nf 1 2 x\n").find("line 6: a face needs three"),
            std::string::npos);
  // Is it 12, or 1 and 2?
  EXPECT_NE(error("a.obj", kVertices + "f 1\\\n2 3\n").find("is not a vertex number"),
            std::string::npos);
  EXPECT_NE(error("a.obj", "v 0 1\\\n2 3\n").find("is not a finite number"), std::string::npos);
  for (const char* cut : {"f 1 2 3 \\", "f 1 2 3\\"})
    EXPECT_NE(error("a.obj", kVertices + cut).find("is not a vertex number"), std::string::npos);
}

TEST_F(TinFile, RefusesObjWithLineEndsOfOldMacs) {
  // The vertex after the return would vanish in the line before it.
  EXPECT_NE(error("a.obj", "v 9 9 9\nv 0 0 5\rv 1 0 6\n" + kVertices + "f 1 2 3\n")
                .find("line 2: this line ends as those of old Macs do"),
            std::string::npos);
  expect_square(read("a.obj", with(kVertices, "\n", "\r\r\n") + "f 1 2 3\nf 1 3 4\r"));
}

TEST_F(TinFile, RefusesNonFiniteBinaryCoordinates) {
  BinaryBody body(false);
  body.put(std::nan(""));
  body.put(0.0);
  const std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty double x\n"
      "property double y\nend_header\n";
  EXPECT_NE(error("a.ply", header + body.text()).find("vertex 0: x is nan"), std::string::npos);
}

TEST_F(TinFile, TellsFormatsWithoutAnExtensionByContent) {
  expect_square(read("mesh", binary_square(true)));
  expect_square(read("mesh", kVertices + "f 1 2 3\nf 1 3 4\n"));
}

TEST_F(TinFile, KnowsItsExtensions) {
  EXPECT_NO_THROW(check_output_extension("a.obj"));
  EXPECT_NO_THROW(check_output_extension("a.b.PLY"));
  for (const char* name : {"a", "a.csv", "a.ply.gz", ".ply", ""}) {
    EXPECT_THROW(check_output_extension(name), ParameterError) << name;
  }
  const std::string message =
      message_of<ParameterError>([&] { write_tin({}, directory_ / "a.step"); });
  EXPECT_NE(message.find("'.step'; known are .obj, .ply"), std::string::npos) << message;
  EXPECT_THROW(read_tin("a.csv"), ParameterError);
  EXPECT_EQ(directory_.entries(), 0u);
}

Tin any_tin(std::size_t points, std::size_t triangles) {
  std::mt19937_64 random(5);
  const auto next = [&] {
    for (;;) {
      const double value = std::bit_cast<double>(random());
      if (std::isfinite(value)) return value;
    }
  };
  Tin tin;
  for (std::size_t i = 0; i < points; ++i) {
    tin.points.xy.push_back({next(), next()});
    tin.points.z.push_back(next());
  }
  for (std::size_t t = 0; t < triangles; ++t) {
    const auto corner = [&] { return static_cast<Index>(random() % points); };
    tin.triangles.push_back({corner(), corner(), corner()});
  }
  tin.crs = "EPSG:25832";
  return tin;
}

TEST_F(TinFile, RoundTripsBitForBit) {
  const Tin tin = any_tin(20000, 40001);
  for (const char* name : {"a.obj", "a.ply"}) {
    write_tin(tin, directory_ / name);
    const Tin back = read_tin(directory_ / name);
    EXPECT_EQ(tin.points.xy, back.points.xy) << name;
    EXPECT_EQ(tin.points.z, back.points.z) << name;
    EXPECT_EQ(tin.triangles, back.triangles) << name;
    EXPECT_EQ(tin.crs, back.crs) << name;
  }
}

TEST_F(TinFile, WritesTheSameBytesOnAnyThreadCount) {
  const Tin tin = any_tin(300000, 300000);
  for (const char* extension : {"obj", "ply"}) {
    std::string bytes[2];
    for (const std::size_t threads : {1, 2}) {
      const ThreadLimit limit(threads);
      const auto path = directory_ / ("a." + std::string(extension));
      write_tin(tin, path);
      bytes[threads - 1] = content_of(path);
    }
    EXPECT_TRUE(bytes[0] == bytes[1]) << extension;
  }
}

TEST_F(TinFile, WritesZeroWhereHeightsAreMissing) {
  Tin tin;
  tin.points.xy = {{0, 0}, {1, 0}, {0, 1}};
  tin.triangles = {{0, 1, 2}};
  for (const char* name : {"a.obj", "a.ply"}) {
    write_tin(tin, directory_ / name);
    EXPECT_EQ(read_tin(directory_ / name).points.z, (std::vector<double>{0, 0, 0}));
  }
  EXPECT_EQ(content_of(directory_ / "a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
}

}  // namespace
}  // namespace hodt
