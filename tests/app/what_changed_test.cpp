// The options --pits and --changed of hodt triangulate.
#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "../io/ogr.h"
#include "command_fixture.h"
#include <gtest/gtest.h>

namespace hodt {
namespace {

using test::content_of;
using test::Json;
using test::ogr_features;
using test::OgrFeature;

class WhatChanged : public test::CommandTest {
 protected:
  void SetUp() override {
    if (!test::has_ogr()) GTEST_SKIP() << "needs the programs of Debian's package gdal-bin";
    ASSERT_EQ(run("sample jacksboro -n 2000 -o points.csv").exit_code, 0);
  }
  void triangulate(const std::string& options) const {
    const auto outcome = run("triangulate points.csv -o out.ply --json report.json " + options);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  std::vector<OgrFeature> features(const char* name) const {
    return ogr_features(directory_ / name);
  }

  /// What the files say is what the report counts, and fits together.
  void check(const std::string& format) const {
    const Json report = json("report.json");
    std::map<std::string, std::size_t> fates;
    std::set<std::pair<long, long>> drained, came, went;
    std::size_t pits = 0, boundary = 0;
    for (const OgrFeature& minimum : features(("pits" + format).c_str())) {
      const auto& v = minimum.values;
      ASSERT_EQ(v.size(), 12u);
      EXPECT_EQ(minimum.type, 1001u);
      const std::string& fate = v[1];
      ++fates[fate];
      const bool was = fate != "new", is = fate != "removed";
      EXPECT_EQ(v[4] != "\\N", was);
      EXPECT_EQ(v[5] != "\\N", was);
      EXPECT_EQ(v[6] != "\\N", is);
      EXPECT_EQ(v[7] != "\\N", is);
      pits += was && v[3] == "1";
      boundary += was && v[2] == "1";
      if (was) {
        EXPECT_GE(std::stod(v[4]), 0);
        EXPECT_EQ(std::stod(v[4]) > 0, std::stod(v[5]) > 0) << "depth and volume";
      }
      for (int i = 8; i < 12; ++i) EXPECT_EQ(v[i] != "\\N", fate == "removed");
      if (fate != "removed") continue;
      EXPECT_LE(std::stod(v[11]), minimum.positions[0][2]) << "it drains downwards";
      drained.insert(std::minmax(std::stol(v[0]), std::stol(v[8])));
    }
    const auto total = [](const Json& split) {
      return split["interior"].get<std::size_t>() + split["boundary"].get<std::size_t>();
    };
    const Json& minima = report["local_minima"];
    EXPECT_EQ(fates["removed"] + fates["kept"] + fates["left"], total(minima["delaunay"]));
    EXPECT_EQ(fates["new"] + fates["kept"] + fates["left"], total(minima["result"]));
    EXPECT_EQ(boundary, minima["delaunay"]["boundary"]);
    EXPECT_LE(pits, total(minima["delaunay"]));
    EXPECT_EQ(fates["kept"], report["kept"]);

    long largest = 0;
    for (const OgrFeature& edge : features(("changed" + format).c_str())) {
      EXPECT_EQ(edge.type, 1002u);
      ASSERT_EQ(edge.values.size(), 4u);
      const std::pair ends(std::stol(edge.values[2]), std::stol(edge.values[3]));
      EXPECT_LT(ends.first, ends.second);
      EXPECT_EQ(edge.values[1] != "\\N", edge.values[0] == "new");
      EXPECT_TRUE((edge.values[0] == "new" ? came : went).insert(ends).second);
      if (edge.values[0] == "new") largest = std::max(largest, std::stol(edge.values[1]));
      if (edge.values[0] == "new") {
        EXPECT_GE(std::stol(edge.values[1]), 1);
      }
    }
    EXPECT_EQ(came.size(), went.size());
    EXPECT_EQ(largest, report["order"]);
    for (const auto& edge : drained) EXPECT_TRUE(came.contains(edge)) << edge.first;
    for (const auto& edge : came) EXPECT_FALSE(went.contains(edge));
  }
};

TEST_F(WhatChanged, FitsTheReportInEveryFormat) {
  for (const std::string format : {".gpkg", ".geojson", ".fgb", ".shp"}) {
    if (!test::writes(format)) continue;
    triangulate("-k 4 --min-pit-depth 3 --pits pits" + format + " --changed changed" + format);
    check(format);
  }
}

TEST_F(WhatChanged, IsToldOfEveryObjective) {
  for (const std::string objective :
       {"min-local-minima", "min-local-maxima", "min-max-angle", "min-max-degree"}) {
    triangulate("-k 2 --objective " + objective + " --pits pits.gpkg --changed changed.gpkg");
    check(".gpkg");
  }
  triangulate("--objective none --pits pits.gpkg --changed changed.gpkg");
  EXPECT_TRUE(features("changed.gpkg").empty());
  for (const OgrFeature& minimum : features("pits.gpkg")) EXPECT_EQ(minimum.values[1], "left");
}

TEST_F(WhatChanged, ChangesNothingElse) {
  triangulate("-k 4");
  const std::string mesh = content_of(directory_ / "out.ply");
  const Json report = json("report.json");
  triangulate("-k 4 --pits pits.gpkg --changed changed.gpkg");
  EXPECT_TRUE(content_of(directory_ / "out.ply") == mesh);
  Json now = json("report.json");
  now["seconds"] = report["seconds"];
  EXPECT_EQ(now, report);
}

TEST_F(WhatChanged, GoesWithConstraints) {
  double low_x = 1e300, low_y = 1e300, high_x = -1e300, high_y = -1e300;
  std::istringstream lines(content_of(directory_ / "points.csv"));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    const double x = std::stod(line), y = std::stod(line.substr(line.find(',') + 1));
    low_x = std::min(low_x, x), high_x = std::max(high_x, x);
    low_y = std::min(low_y, y), high_y = std::max(high_y, y);
  }
  const auto at = [&](double across, double up) {
    return "[" + std::to_string(low_x + across * (high_x - low_x)) + "," +
           std::to_string(low_y + up * (high_y - low_y)) + "]";
  };
  // Two squares that touch in a corner, and a hole.
  const auto square = [&](double x, double y, double side) {
    return "[" + at(x, y) + "," + at(x + side, y) + "," + at(x + side, y + side) + "," +
           at(x, y + side) + "," + at(x, y) + "]";
  };
  put("outline.geojson", "{\"type\":\"MultiPolygon\",\"coordinates\":[[" + square(0.1, 0.1, 0.4) +
                             "," + square(0.2, 0.2, 0.1) + "],[" + square(0.5, 0.5, 0.3) + "]]}");
  triangulate("-k 4 --outline outline.geojson --pits pits.gpkg --changed changed.gpkg");
  check(".gpkg");
}

TEST_F(WhatChanged, RefusesWhatCannotBe) {
  const std::string start = "triangulate points.csv -o a.ply ";
  expect_refused(start + "--pits a.obj", "cannot write features to a.obj");
  expect_refused(start + "--changed a.csv", "cannot write features to a.csv");
  expect_refused(start + "--pits a.gpkg --changed ./a.gpkg", "which is another output as well");
  expect_refused("triangulate points.csv -o a.gpkg --pits a.gpkg", "another output as well");
  expect_refused(start + "--pits none/a.gpkg", "there is no directory");
  put("flat.csv", "x,y\n0,0\n1,0\n0,1\n1,1.5\n");
  expect_refused("triangulate flat.csv --objective none -o a.ply --pits a.gpkg",
                 "--pits needs heights");
  put("lines.geojson", "{\"type\":\"LineString\",\"coordinates\":[[0,0],[1,1]]}");
  expect_refused(
      "triangulate flat.csv --objective none -o a.ply --breaklines lines.geojson "
      "--changed lines.geojson",
      "is the input");
  put("pits.gpkg", "an existing output");
  expect_refused(start + "--pits pits.gpkg --json /dev/full", "/dev/full");
  EXPECT_EQ(content_of(directory_ / "pits.gpkg"), "an existing output");
}

}  // namespace
}  // namespace hodt
