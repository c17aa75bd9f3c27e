#include "hodt/terrain/terrain.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"
#include "hodt/terrain/eroded_grid.h"
#include "hodt/terrain/jacksboro.h"
#include "hodt/terrain/random.h"
#include "hodt/terrain/valley.h"

namespace hodt {
namespace {

/// FNV-1a over the bits of all coordinates.
std::uint64_t checksum(const PointSet& points) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&](double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    for (int byte = 0; byte < 8; ++byte) hash = (hash ^ (bits >> 8 * byte & 255)) * 0x100000001b3u;
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    add(points.xy[i].x);
    add(points.xy[i].y);
    add(points.z[i]);
  }
  return hash;
}

std::set<std::pair<double, double>> places(const PointSet& points) {
  std::set<std::pair<double, double>> result;
  for (const Point& p : points.xy) result.emplace(p.x, p.y);
  return result;
}

template <class Height>
std::size_t interior_pits(const TriangularGrid& grid, const Height& height) {
  std::size_t pits = 0;
  for (std::size_t vertex = 0; vertex < grid.size(); ++vertex) {
    if (grid.on_border(vertex)) continue;
    const Neighbours neighbours = neighbours_of(grid, vertex);
    pits += std::none_of(neighbours.begin(), neighbours.end(),
                         [&](Index next) { return height(next) < height(vertex); });
  }
  return pits;
}

TEST(Random, IsTheSameEverywhere) {
  // The published SplitMix64 from state 1234567.
  EXPECT_EQ(random_bits(1234567, 0), 6457827717110365317u);
  EXPECT_EQ(random_bits(1234567, 1), 3203168211198807973u);
  for (std::uint64_t i = 0; i < 1000; ++i) {
    EXPECT_LT(random_below(7, 1, i), 7u);
    EXPECT_LT(random_unit(1, i), 1.0);
  }
}

TEST(Terrains, AreListed) {
  ASSERT_EQ(built_in_terrains().size(), 2u);
  EXPECT_EQ(built_in_terrains()[0].name, "jacksboro");
  EXPECT_EQ(built_in_terrains()[1].name, "valley");
  for (const TerrainInfo& info : built_in_terrains()) {
    EXPECT_EQ(sample_terrain(info.name, 0, 1).size(), info.default_points) << info.name;
  }
}

TEST(Terrains, RefuseUnknownNamesAndTellTheKnownOnes) {
  try {
    sample_terrain("vally", 10, 1);
    FAIL() << "accepted";
  } catch (const ParameterError& error) {
    EXPECT_NE(std::string(error.what()).find("'vally'"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("jacksboro, valley"), std::string::npos);
  }
}

TEST(Terrains, RefuseMorePointsThanThereAre) {
  EXPECT_THROW(sample_terrain("jacksboro", 10'001, 1), ParameterError);
  EXPECT_THROW(sample_terrain("valley", kMostValleyPoints + 1, 1), ParameterError);
}

TEST(Jacksboro, IsTheCommittedFile) {
  const auto root = std::filesystem::path(__FILE__).parent_path() / ".." / "..";
  std::ifstream file(root / "data" / "jacksboro.csv", std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_EQ(jacksboro_csv(), text.str());
}

TEST(Jacksboro, HasTheRowsOfTheFileInOrder) {
  const PointSet points = sample_terrain("jacksboro", 0, 1);
  std::istringstream lines{std::string(jacksboro_csv())};
  std::string line;
  ASSERT_TRUE(std::getline(lines, line));
  EXPECT_EQ(line, "x,y,z");
  for (std::size_t i = 0; i < points.size(); ++i) {
    Point p;
    double z = 0;
    char comma = 0;
    ASSERT_TRUE(lines >> p.x >> comma >> p.y >> comma >> z) << "row " << i;
    ASSERT_EQ(points.xy[i], p) << "row " << i;
    ASSERT_EQ(points.z[i], z) << "row " << i;
  }
  EXPECT_FALSE(lines >> line);
}

TEST(Jacksboro, GivesSubsetsOfEverySize) {
  const auto all = places(sample_terrain("jacksboro", 0, 1));
  EXPECT_EQ(all.size(), kJacksboroPoints);
  for (const std::size_t n : {1u, 2u, 100u, 5000u, 9999u, 10000u}) {
    const auto some = places(sample_terrain("jacksboro", n, 7));
    EXPECT_EQ(some.size(), n);
    EXPECT_TRUE(std::includes(all.begin(), all.end(), some.begin(), some.end()));
  }
  EXPECT_NE(places(sample_terrain("jacksboro", 100, 1)),
            places(sample_terrain("jacksboro", 100, 2)));
}

TEST(Valley, IsTheSameToTheBitEverywhere) {
  // If this fails after a change meant to change the terrain, take the new value; on a new machine
  // or compiler, find out why.
  EXPECT_EQ(checksum(sample_terrain("valley", 20'000, 1)), 15559509086570186980u);
}

TEST(Valley, DoesNotDependOnThreads) {
  const std::uint64_t free = checksum(sample_terrain("valley", 20'000, 5));
  const ThreadLimit one(1);
  EXPECT_EQ(checksum(sample_terrain("valley", 20'000, 5)), free);
}

TEST(Valley, DependsOnTheSeed) {
  EXPECT_NE(checksum(sample_terrain("valley", 1000, 1)),
            checksum(sample_terrain("valley", 1000, 2)));
}

TEST(Valley, FillsItsSquare) {
  for (const std::size_t n : {1u, 3u, 100u, 4096u, 30'000u}) {
    const PointSet points = sample_terrain("valley", n, 3);
    ASSERT_EQ(points.size(), n);
    ASSERT_TRUE(points.has_heights());
    const double side = valley_side(n) / 1000.0;
    double east = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Point& p = points.xy[i];
      ASSERT_TRUE(0 <= p.x && p.x <= side && 0 <= p.y && p.y <= side) << p.x << ' ' << p.y;
      ASSERT_TRUE(-1000 < points.z[i] && points.z[i] < 3000) << points.z[i];
      ASSERT_EQ(p.x, std::round(p.x * 1000) / 1000);
      ASSERT_EQ(points.z[i], std::round(points.z[i] * 1000) / 1000);
      east = std::max(east, p.x);
    }
    if (n >= 100) {
      EXPECT_GT(east, 0.9 * side);
    }
    EXPECT_EQ(places(points).size(), n);
  }
}

TEST(Valley, HasNoPitInside) {
  for (const std::size_t n : {1u, 5'000u, 50'000u, 400'000u}) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      const TriangularGrid grid = valley_grid(n, seed);
      EXPECT_EQ(interior_pits(grid, [&](std::size_t i) { return grid.height[i]; }), 0u);
      const auto rounded = [&](std::size_t i) { return std::llround(grid.height[i] * 1000); };
      EXPECT_EQ(interior_pits(grid, rounded), 0u) << "rounded to millimetres, n = " << n;
    }
  }
}

TEST(TriangularGrid, InterpolatesItsVertices) {
  const TriangularGrid grid = valley_grid(1000, 1);
  for (std::size_t row = 0; row + 1 < grid.rows; ++row) {
    for (std::size_t column = 1; column + 1 < grid.columns; ++column) {
      const double x = (static_cast<double>(column) + (row % 2 ? 0.5 : 0)) * grid.spacing;
      const double y = static_cast<double>(row) * grid.row_spacing();
      EXPECT_NEAR(grid.height_at(x, y), grid.height[row * grid.columns + column], 1e-6);
    }
  }
}

TEST(TriangularGrid, InterpolatesPlanesExactly) {
  TriangularGrid grid{5, 6, 2.0, std::vector<double>(30)};
  const auto plane = [](double x, double y) { return 3 + 0.25 * x - 0.5 * y; };
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const std::size_t row = i / 5;
    grid.height[i] = plane((static_cast<double>(i % 5) + (row % 2 ? 0.5 : 0)) * 2,
                           static_cast<double>(row) * grid.row_spacing());
  }
  for (double x = 1; x < 8; x += 0.19) {
    for (double y = 0; y < 5 * grid.row_spacing(); y += 0.17) {
      EXPECT_NEAR(grid.height_at(x, y), plane(x, y), 1e-12) << x << ' ' << y;
    }
  }
}

TEST(TriangularGrid, NeighboursAreMutualAndEquallyFar) {
  const TriangularGrid grid{4, 5, 1.0, std::vector<double>(20)};
  for (std::size_t vertex = 0; vertex < grid.size(); ++vertex) {
    const Neighbours neighbours = neighbours_of(grid, vertex);
    EXPECT_EQ(neighbours.count == 6, !grid.on_border(vertex));
    for (const Index next : neighbours) {
      const Neighbours back = neighbours_of(grid, next);
      EXPECT_EQ(std::count(back.begin(), back.end(), vertex), 1);
      const auto row_of = [](std::size_t v) { return static_cast<double>(v / 4); };
      const auto x_of = [](std::size_t v) {
        return static_cast<double>(v % 4) + (v / 4 % 2 ? 0.5 : 0);
      };
      EXPECT_NEAR(std::hypot(x_of(vertex) - x_of(next),
                             (row_of(vertex) - row_of(next)) * grid.row_spacing()),
                  1, 1e-12);
    }
  }
}

}  // namespace
}  // namespace hodt
