// Between hodt's types and those of the oracle and the families.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "families.h"
#include "oracle.h"

#include "hodt/delaunay/delaunay.h"
#include "hodt/geometry/point_set.h"
#include "hodt/mesh/triangle_mesh.h"

namespace support {

inline hodt::PointSet to_point_set(const families::Points& points,
                                   const families::Heights& z = {}) {
  hodt::PointSet set;
  for (const auto& [x, y] : points) set.xy.push_back({x, y});
  set.z = z;
  return set;
}

inline oracle::Points to_oracle(std::span<const hodt::Point> points) {
  oracle::Points pairs;
  for (const hodt::Point& p : points) pairs.emplace_back(p.x, p.y);
  return pairs;
}

/// The smallest corner first, the turn as it is.
inline oracle::Triangle canonical(oracle::Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/// The triangles of a mesh, in its own numbering: canonical and sorted.
inline oracle::Triangles triangles_of(const hodt::TriangleMesh& mesh) {
  oracle::Triangles triangles;
  for (hodt::Index t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(hodt::TriangleId(t));
    triangles.push_back(canonical({static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)}));
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

/// The triangles as input rows: canonical and sorted.
inline oracle::Triangles rows_of(const hodt::Delaunay& delaunay) {
  oracle::Triangles triangles = triangles_of(delaunay.mesh);
  for (oracle::Triangle& t : triangles) {
    for (int& corner : t) corner = static_cast<int>(delaunay.vertices.row[corner]);
    t = canonical(t);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

inline bool same_arrays(const hodt::TriangleMesh& a, const hodt::TriangleMesh& b) {
  return a.vertex_count() == b.vertex_count() && std::ranges::equal(a.origins(), b.origins()) &&
         std::ranges::equal(a.twins(), b.twins());
}

/// The points as C++ source, so that a failure can become a test of its own.
inline std::string to_source(std::span<const hodt::Point> points, std::span<const double> z = {}) {
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "points {";
  for (const auto& [x, y] : points) out << "{" << x << ", " << y << "}, ";
  out << "} heights {";
  for (const double height : z) out << height << ", ";
  out << "}";
  return out.str();
}

/// A small mesh from its triangles: edges are found by looking at all pairs.
inline hodt::TriangleMesh make_mesh(std::size_t vertices,
                                    const std::vector<std::array<hodt::Index, 3>>& triangles) {
  using hodt::HalfEdgeId;
  using hodt::Index;
  const auto size = static_cast<Index>(3 * triangles.size());
  hodt::TriangleMesh mesh(vertices, hodt::Buffer<Index>(size),
                          hodt::Buffer<Index>(size, hodt::kNone));
  for (Index h = 0; h < size; ++h)
    mesh.set_origin(HalfEdgeId(h), hodt::VertexId(triangles[h / 3][h % 3]));
  for (Index h = 0; h < size; ++h)
    for (Index g = 0; g < h; ++g)
      if (mesh.origin(HalfEdgeId(g)) == mesh.target(HalfEdgeId(h)) &&
          mesh.target(HalfEdgeId(g)) == mesh.origin(HalfEdgeId(h)))
        mesh.glue(HalfEdgeId(g), HalfEdgeId(h));
  return mesh;
}

}  // namespace support
