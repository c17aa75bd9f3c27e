// The options --picture and --window of hodt triangulate.
#include <string>

#include "command_fixture.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/io/formats.h"
#include "hodt/io/picture_file.h"

namespace hodt {
namespace {

using test::content_of;
using test::Json;

bool has_renderer() {
  try {
    check_picture_output("a.png");
    return true;
  } catch (const ParameterError&) {
    return false;
  }
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
  return found;
}

class PictureCommand : public test::CommandTest {
 protected:
  /// The picture of a run, as SVG.
  std::string picture(const std::string& arguments) const {
    const auto outcome = run("triangulate " + arguments + " -o out.ply --picture view.svg");
    EXPECT_EQ(outcome.exit_code, 0) << arguments << ": " << outcome.err;
    return content_of(directory_ / "view.svg");
  }
  void sample(const std::string& arguments) const {
    ASSERT_EQ(run("sample " + arguments + " -o points.csv").exit_code, 0);
  }
};

TEST_F(PictureCommand, ShowsWhatTheReportCounts) {
  sample("jacksboro -n 2000");
  const std::string svg = picture("points.csv -k 8 --json report.json");
  const Json minima = json("report.json")["local_minima"];
  const auto total = [&](const char* which) {
    return std::to_string(minima[which]["interior"].get<int>() +
                          minima[which]["boundary"].get<int>());
  };
  EXPECT_NE(svg.find(">Delaunay: " + total("delaunay") + " local minima<"), std::string::npos);
  EXPECT_NE(svg.find(">order 8, min-local-minima: " + total("result") + " local minima<"),
            std::string::npos);
  EXPECT_NE(svg.find("points.csv: Delaunay and order 8"), std::string::npos);
  EXPECT_NE(svg.find("new edge of order 1 ("), std::string::npos);
  EXPECT_NE(svg.find("new edge of order 5 to 8 ("), std::string::npos);
  EXPECT_EQ(count(svg, "class=\"vanished\""),
            std::stoul(total("delaunay")) - count(svg, "class=\"remains\"") / 2);
}

TEST_F(PictureCommand, ChangesNothingElse) {
  sample("jacksboro -n 1000");
  ASSERT_EQ(run("triangulate points.csv -o plain.vtu --json plain.json").exit_code, 0);
  ASSERT_EQ(run("triangulate points.csv -o out.vtu --json out.json --picture view.svg").exit_code,
            0);
  EXPECT_EQ(content_of(directory_ / "out.vtu"), content_of(directory_ / "plain.vtu"));
  Json plain = json("plain.json"), out = json("out.json");
  plain["seconds"] = out["seconds"];
  EXPECT_EQ(plain, out);
}

TEST_F(PictureCommand, IsTheSameOnAnyNumberOfThreads) {
  sample("jacksboro -n 6000");
  const std::string one = picture("points.csv --threads 1");
  EXPECT_EQ(picture("points.csv --threads 3"), one);
  EXPECT_NE(one.find("the part shown,"), std::string::npos) << "in a small map";
}

TEST_F(PictureCommand, GoesWithEveryObjective) {
  sample("jacksboro -n 400");
  for (const std::string objective : {"min-local-maxima", "min-local-extrema", "min-max-degree",
                                      "min-max-angle", "min-sum-length", "min-sum-abn", "none"}) {
    const std::string svg = picture("points.csv -k 3 --objective " + objective);
    EXPECT_EQ(svg.find("local maxima") != svg.npos,
              objective == "min-local-maxima" || objective == "min-local-extrema")
        << objective;
    EXPECT_EQ(svg.find("local minima") == svg.npos, objective == "min-local-maxima") << objective;
    EXPECT_EQ(svg.find("new edge") == svg.npos, objective == "none") << objective;
  }
}

TEST_F(PictureCommand, GoesWithLinesAndOutlines) {
  sample("jacksboro -n 500");
  const Json info = [&] {
    EXPECT_EQ(run("info points.csv --json info.json").exit_code, 0);
    return json("info.json");
  }();
  const auto at = [&](double u, double v) {
    const auto between = [&](const char* axis, double share) {
      const double low = info[axis][0], high = info[axis][1];
      return std::to_string(low + share * (high - low));
    };
    std::string place = "[";
    return place.append(between("x", u)).append(",").append(between("y", v)).append("]");
  };
  put("road.geojson",
      "{\"type\":\"LineString\",\"coordinates\":[" + at(0.3, 0.3) + "," + at(0.7, 0.6) + "]}");
  put("site.geojson", "{\"type\":\"Polygon\",\"coordinates\":[[" + at(0.1, 0.1) + "," +
                          at(0.9, 0.1) + "," + at(0.9, 0.9) + "," + at(0.1, 0.9) + "," +
                          at(0.1, 0.1) + "]]}");
  const std::string svg =
      picture("points.csv --breaklines road.geojson --outline site.geojson -k 3");
  EXPECT_NE(svg.find("Constrained Delaunay"), std::string::npos);
  EXPECT_GT(count(svg, "class=\"breakline\""), 0u);
  // A mesh, too.
  ASSERT_EQ(run("triangulate points.csv -o mesh.obj -k 0").exit_code, 0);
  EXPECT_NE(picture("mesh.obj -k 3").find("mesh.obj: "), std::string::npos);
}

TEST_F(PictureCommand, GoesWithoutHeights) {
  put("flat.csv", "x,y\n0,0\n4,0\n2,-1\n2,1.5\n1,3\n3,-4\n");
  const std::string svg = picture("flat.csv --objective min-max-angle");
  EXPECT_EQ(count(svg, "minim"), 0u);
  EXPECT_NE(svg.find("units of x and y"), std::string::npos);
}

TEST_F(PictureCommand, SaysTheUnit) {
  if (!has_gdal()) GTEST_SKIP() << "units are known to GDAL";
  put("points.csv", "x,y,z\n7,50,1\n7.1,50,2\n7,50.1,3\n7.1,50.11,0\n");
  EXPECT_NE(picture("points.csv --crs EPSG:4326").find("x and y are degrees"), std::string::npos);
  EXPECT_NE(picture("points.csv --crs EPSG:25832").find(">0.02 m<"), std::string::npos);
  EXPECT_NE(picture("points.csv --crs EPSG:2263").find(">0.02 ft<"), std::string::npos);
  EXPECT_NE(picture("points.csv --crs EPSG:25832+7837").find(">0.00 to 3.00 m<"),
            std::string::npos);
}

TEST_F(PictureCommand, IsDrawnAsPixels) {
  if (!has_renderer()) GTEST_SKIP() << "needs librsvg (Debian's package librsvg2-2)";
  sample("jacksboro -n 4000");
  ASSERT_EQ(run("triangulate points.csv -o out.ply --picture view.PNG").exit_code, 0);
  const std::string png = content_of(directory_ / "view.PNG");
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  const auto number = [&](std::size_t at) {
    return static_cast<unsigned char>(png[at + 2]) * 256 + static_cast<unsigned char>(png[at + 3]);
  };
  EXPECT_EQ(number(16), 2 * 1392);
  EXPECT_GT(png.size(), 300000u) << "it is not empty";
}

TEST_F(PictureCommand, RefusesWhatCannotBe) {
  sample("jacksboro -n 100");
  const std::string start = "triangulate points.csv -o a.ply --picture ";
  expect_refused(start + "a.pdf", "cannot write a picture to a.pdf: known are .svg, .png");
  expect_refused(start + "view", "known are .svg, .png");
  expect_refused(start + "none/a.svg", "there is no directory");
  expect_refused(start + "points.csv", "known are .svg, .png");
  expect_refused(start + "a.svg --json ./a.svg", "--picture names a.svg, which is another output");
  expect_refused("triangulate points.csv -o a.ply --window 0,0,1,1", "--window is for --picture");
  for (const std::string window : {"1,2,3", "1,2,3,4,5", "2,0,1,1", "0,0,1,0"})
    expect_refused(start + "a.svg --window " + window, "--window must be XMIN,YMIN,XMAX,YMAX");
  for (const std::string window : {"1,2,3,x", "1,2,3,", "0,0,inf,1", "nan,0,1,1"})
    expect_refused(start + "a.svg --window " + window, "--window must be");
  expect_refused(start + "a.svg --window=-3,-3,-2,-2", "no point is in the picture's window");
  put("view.svg", "an existing picture");
  expect_refused(start + "view.svg --window=-3,-3,-2,-2", "points.csv: no point is in");
  expect_refused(start + "view.svg --json /dev/full", "/dev/full");
  EXPECT_EQ(content_of(directory_ / "view.svg"), "an existing picture");
}

TEST_F(PictureCommand, MarksMinimaApartThatWereToStay) {
  sample("jacksboro -n 2000");
  const std::string svg = picture("points.csv -k 8 --min-pit-depth 3 --json report.json");
  const std::size_t kept = json("report.json")["kept"].get<std::size_t>();
  EXPECT_GT(kept, 0u);
  EXPECT_EQ(count(svg, "class=\"held\""), 2 * kept);
  EXPECT_NE(svg.find(">local minimum that was to stay (" + std::to_string(kept) + " here)<"),
            std::string::npos);
  EXPECT_EQ(picture("points.csv -k 8").find("was to stay"), std::string::npos);
}

TEST_F(PictureCommand, NamesAllObjectivesOfAList) {
  sample("jacksboro -n 500");
  const std::string svg =
      picture("points.csv -k 2 --objective min-local-minima,min-sum-abn,min-local-maxima");
  std::string caption = svg.substr(svg.find("No height was changed"));
  EXPECT_NE(svg.find("order 2, min-local-minima, then min-sum-abn, then min-local-maxima: "),
            std::string::npos);
  for (const char* name : {"min-local-minima: ", "min-sum-abn: ", "min-local-maxima: "})
    EXPECT_NE(caption.find(name), std::string::npos) << name;
  EXPECT_NE(svg.find(">local maximum that stays ("), std::string::npos);
}

}  // namespace
}  // namespace hodt
