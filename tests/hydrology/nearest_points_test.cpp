#include "hodt/hydrology/nearest_points.h"

#include <cmath>

#include "../support/shapes.h"
#include <gtest/gtest.h>

#include "hodt/delaunay/spatial_order.h"

namespace hodt {
namespace {

Index nearest(std::span<const Point> points, const Point& place) {
  Index best = 0;
  const auto distance = [&](const Point& p) {
    return std::hypot(p.x / 4 - place.x / 4, p.y / 4 - place.y / 4);
  };
  for (Index i = 1; i < points.size(); ++i)
    if (distance(points[i]) < distance(points[best])) best = i;
  return best;
}

TEST(NearestPoints, are_those_that_all_distances_tell) {
  families::Random random(1);
  for (const auto& points : {support::uniform(500, 2), support::clustered(500, 3),
                             support::lattice(20, 20), support::Points{{3, 4}}}) {
    const Buffer<Point> sorted = spatial_order({points, {}}).vertices.xy;
    std::vector<Point> places;
    for (int i = 0; i < 200; ++i) {
      places.push_back({random.real(-1, 2), random.real(-1, 2)});
      places.push_back({random.integer(-1, 40) / 2.0, random.integer(-1, 40) / 2.0});  // ties
    }
    places.push_back({1e308, -1e308});
    const std::vector<VertexId> found = nearest_points(sorted, places);
    for (std::size_t i = 0; i < places.size(); ++i) EXPECT_EQ(found[i], nearest(sorted, places[i]));
  }
}

}  // namespace
}  // namespace hodt
