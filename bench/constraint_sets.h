// Points with edges that have to be there, to time on: the same on every run.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include "point_sets.h"

#include "hodt/delaunay/delaunay.h"
#include "hodt/geometry/constraints.h"
#include "hodt/geometry/point_set.h"
#include "hodt/mesh/triangle_mesh.h"
#include "hodt/order/segment_walk.h"
#include "hodt/terrain/noise.h"

namespace constraint_sets {

struct Set {
  hodt::PointSet points;
  std::vector<hodt::Constraints::Edge> edges;
};

/// Smooth hills, eight to a side of the unit square.
inline double surface(const hodt::Point& p) {
  return hodt::fractal_noise(8 * p.x, 8 * p.y, 2, 1);
}

/// The same, rough: so that it has pits.
inline double rough_surface(const hodt::Point& p) {
  return surface(p) + 0.01 * hodt::fractal_noise(300 * p.x, 300 * p.y, 3, 2);
}

/// Takes segments between vertices of a Delaunay triangulation that have no point in common: no two
/// cross the same triangle, nor end at the same vertex.
class DisjointSegments {
 public:
  explicit DisjointSegments(const hodt::Delaunay& delaunay)
      : delaunay_(delaunay),
        outgoing_(hodt::outgoing_halfedges(delaunay.mesh)),
        is_end_(delaunay.vertices.size(), false),
        is_crossed_(delaunay.mesh.triangle_count(), false) {}

  /// False if it is in the way of another one, or is a Delaunay edge.
  bool take(hodt::VertexId from, hodt::VertexId to) {
    if (from == to || is_end_[from] || is_end_[to]) return false;
    const hodt::TriangleMesh& mesh = delaunay_.mesh;
    bool is_edge = false;
    hodt::for_each_neighbour(mesh, outgoing_[from], [&](hodt::VertexId v) { is_edge |= v == to; });
    if (is_edge) return false;
    way_.clear();
    hodt::for_each_crossed(mesh, delaunay_.vertices.xy, outgoing_, from, to,
                           [&](hodt::HalfEdgeId h) {
                             way_.push_back(hodt::TriangleMesh::triangle(h));
                             way_.push_back(hodt::TriangleMesh::triangle(mesh.twin(h)));
                           });
    for (const hodt::TriangleId t : way_)
      if (is_crossed_[t]) return false;
    for (const hodt::TriangleId t : way_) is_crossed_[t] = true;
    is_end_[from] = is_end_[to] = true;
    return true;
  }

  /// As many edges away as that at most.
  template <class Random>
  hodt::VertexId walk(hodt::VertexId from, int steps, Random& random) const {
    std::vector<hodt::VertexId> neighbours;
    for (; steps > 0; --steps) {
      neighbours.clear();
      hodt::for_each_neighbour(delaunay_.mesh, outgoing_[from],
                               [&](hodt::VertexId v) { neighbours.push_back(v); });
      from = neighbours[random() % neighbours.size()];
    }
    return from;
  }

 private:
  const hodt::Delaunay& delaunay_;
  hodt::Buffer<hodt::HalfEdgeId> outgoing_;
  hodt::Buffer<bool> is_end_, is_crossed_;
  std::vector<hodt::TriangleId> way_;
};

/// Uniform points, and `edges` segments between points that are two or three Delaunay edges apart,
/// no two of which touch.
inline Set segments(std::size_t n, std::size_t edges) {
  Set set{{point_sets::uniform(n), {}}, {}};
  for (const hodt::Point& p : set.points.xy) set.points.z.push_back(rough_surface(p));
  const hodt::Delaunay delaunay = hodt::delaunay(set.points);
  DisjointSegments taken(delaunay);
  std::mt19937_64 random(8);
  while (set.edges.size() < edges) {
    const hodt::VertexId from(static_cast<hodt::Index>(random() % delaunay.vertices.size()));
    const hodt::VertexId to = taken.walk(from, 3, random);
    if (taken.take(from, to))
      set.edges.push_back({delaunay.vertices.row[from], delaunay.vertices.row[to]});
  }
  return set;
}

/// The level sets of the surface over the unit square, as it is linear on the triangles of a grid.
class LevelSets {
 public:
  LevelSets(std::size_t cells, double interval) : cells_(cells), interval_(interval) {
    for (std::size_t j = 0; j < cells; ++j)
      for (std::size_t i = 0; i < cells; ++i) {
        const Corner a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1),
                     d = corner(i, j + 1);
        cut(a, b, c);
        cut(a, c, d);
      }
  }
  Set lines() && { return std::move(lines_); }

 private:
  struct Corner {
    std::size_t number;
    hodt::Point at;
    double z;
  };

  Corner corner(std::size_t i, std::size_t j) const {
    const hodt::Point at{double(i) / double(cells_), double(j) / double(cells_)};
    return {j * (cells_ + 1) + i, at, surface(at)};
  }

  void cut(Corner low, Corner middle, Corner high) {
    if (low.z > middle.z) std::swap(low, middle);
    if (middle.z > high.z) std::swap(middle, high);
    if (low.z > middle.z) std::swap(low, middle);
    for (double level = std::floor(low.z / interval_) + 1; level * interval_ < high.z; ++level) {
      const bool is_low = level * interval_ < middle.z;
      lines_.edges.push_back({vertex(low, high, level),
                              is_low ? vertex(low, middle, level) : vertex(middle, high, level)});
    }
  }

  hodt::Index vertex(const Corner& low, const Corner& high, double level) {
    const auto [known, is_new] =
        vertices_.try_emplace({low.number, high.number, level}, hodt::Index(lines_.points.size()));
    if (is_new) {
      const double z = level * interval_, part = (z - low.z) / (high.z - low.z);
      lines_.points.xy.push_back(
          {low.at.x + part * (high.at.x - low.at.x), low.at.y + part * (high.at.y - low.at.y)});
      lines_.points.z.push_back(z);
    }
    return known->second;
  }

  std::size_t cells_;
  double interval_;
  Set lines_;
  std::map<std::tuple<std::size_t, std::size_t, double>, hodt::Index> vertices_;
};

/// Contours of about so many edges, each about as long as points are apart, among uniform points.
inline Set contours(std::size_t n, std::size_t edges) {
  const auto cells = static_cast<std::size_t>(0.7 * std::sqrt(double(n)));
  constexpr double kInterval = 0.1;
  const std::size_t count = LevelSets(cells, kInterval).lines().edges.size();
  Set set = LevelSets(cells, kInterval * double(count) / double(edges)).lines();
  for (const hodt::Point& p : point_sets::uniform(n - set.points.size())) {
    set.points.xy.push_back(p);
    set.points.z.push_back(rough_surface(p));
  }
  return set;
}

}  // namespace constraint_sets
