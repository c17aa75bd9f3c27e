// Meshes that writers are tested with.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "hodt/delaunay/delaunay.h"
#include "hodt/io/formats.h"
#include "hodt/tin/tin.h"

namespace hodt::test {

/// Scattered points, by a generator of our own so that it is the same everywhere.
class Scatter {
 public:
  /// A number from 0 to 1 with all its bits.
  double next() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state_ >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_ = 20;
};

/// So many points of a survey, their Delaunay triangulation, and an order for each triangle.
inline Tin survey(std::size_t count, std::string crs = "EPSG:25832") {
  Scatter scatter;
  Tin tin;
  for (std::size_t i = 0; i < count; ++i) {
    tin.points.xy.push_back({512345.5 + 900 * scatter.next(), 5403210.25 + 700 * scatter.next()});
    tin.points.z.push_back(300 + 90 * scatter.next());
  }
  const Delaunay delaunay = hodt::delaunay(tin.points);
  for (Index t = 0; t < delaunay.mesh.triangle_count(); ++t) {
    const auto [a, b, c] = delaunay.mesh.corners(TriangleId(t));
    const auto& row = delaunay.vertices.row;
    tin.triangles.push_back({row[a], row[b], row[c]});
    tin.order.push_back(t % 4 == 0 ? t % 7 : 0);
  }
  tin.crs = std::move(crs);
  return tin;
}

/// A triangle without heights, orders and a reference system.
inline Tin plain_triangle() {
  return {{{{0, 0}, {1, 0}, {0, 1}}, {}}, {{0, 1, 2}}, {}};
}

/// Coordinates of every size.
inline Tin extreme() {
  Tin tin = plain_triangle();
  tin.points = {{{-1e300, 5e-324}, {1e300, -0.0}, {1e17, 1.0000000000000002}},
                {1e-310, -1e308, 0.1}};
  tin.order = {3000000000u};
  return tin;
}

inline const char* wkt() {
  return "PROJCRS[\"ETRS89 / <UTM> & \xc3\xb6stlich\",\n    ID[\"EPSG\",25832]]";
}

/// The formats that meshes are written in.
inline std::vector<const Format*> mesh_formats() {
  std::vector<const Format*> all;
  for (const Format& format : formats())
    if (can(format, Use::write_tin)) all.push_back(&format);
  return all;
}

inline std::string first_extension(const Format& format) {
  return std::string(extensions_of(format).front());
}

}  // namespace hodt::test
