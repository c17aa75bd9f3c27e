// What it costs to find the points in polygons, against the Delaunay triangulation of the points:
// lakes of 200 corners that are small, cover half of the map, or overlap, and lakes of very many
// corners.
//
//   keep_vs_delaunay [--n 100000] [--runs 5] [--threads 1]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <vector>

#include "duel.h"
#include "point_sets.h"

#include "hodt/base/parallel.h"
#include "hodt/delaunay/delaunay.h"
#include "hodt/hydrology/nearest_points.h"
#include "hodt/hydrology/points_in_polygons.h"

namespace {

using Polygons = std::vector<hodt::Polygon>;

/// A lake with a ragged shore.
hodt::Polygon lake(const hodt::Point& centre, double radius, std::size_t corners,
                   std::mt19937_64& random) {
  std::uniform_real_distribution<double> reach(1 - std::min(0.3, 6 / std::sqrt(double(corners))),
                                               1);
  std::vector<hodt::Point> ring(corners);
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * double(i) / double(corners);
    const double r = radius * reach(random);
    ring[i] = {centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)};
  }
  return {{std::move(ring)}};
}

Polygons lakes(std::size_t count, double radius, std::size_t corners) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  Polygons polygons;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = unit(random), y = unit(random);
    polygons.push_back(lake({x, y}, radius, corners, random));
  }
  return polygons;
}

void compare(const char* name, const std::vector<hodt::Point>& points, const Polygons& polygons,
             std::size_t runs) {
  std::vector<double> triangulation, location;
  std::size_t inside = 0;
  for (std::size_t run = 0; run < runs; ++run) {
    hodt::Delaunay delaunay;
    triangulation.push_back(duel::seconds([&] { delaunay = hodt::delaunay({points, {}}); }));
    location.push_back(duel::seconds([&] {
      const auto found = hodt::points_in_polygons(delaunay.vertices.xy, polygons);
      inside = std::size_t(std::count(found.is_inside.begin(), found.is_inside.end(), true));
    }));
  }
  const double a = duel::median(triangulation), b = duel::median(location);
  std::printf("%-34s triangulation %7.1f ms, polygons %7.1f ms (%.2f x), %zu points inside\n", name,
              1e3 * a, 1e3 * b, b / a, inside);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t n = duel::option(argc, argv, "--n", 100000);
  const std::size_t runs = duel::option(argc, argv, "--runs", 5);
  const hodt::ThreadLimit limit(duel::option(argc, argv, "--threads", 1));
  const std::vector<hodt::Point> points = point_sets::uniform(n);
  compare("3000 lakes of 200 corners, small", points, lakes(3000, 0.003, 200), runs);
  compare("3000 lakes, on half of the map", points, lakes(3000, 0.007, 200), runs);
  compare("3000 lakes, each on another", points, lakes(3000, 0.012, 200), runs);
  compare("100 lakes of 20000 corners", points, lakes(100, 0.1, 20000), runs);
  compare("1 lake of 200000 corners", points, lakes(1, 0.4, 200000), runs);
  const std::vector<hodt::Point> places = point_sets::uniform(3000);
  const hodt::Delaunay delaunay = hodt::delaunay({points, {}});
  const double seconds = duel::seconds([&] { hodt::nearest_points(delaunay.vertices.xy, places); });
  std::printf("3000 places, nearest points: %.1f ms\n", 1e3 * seconds);
}
