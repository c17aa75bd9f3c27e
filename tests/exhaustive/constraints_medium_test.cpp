// hodt::triangulate with a hundred breaklines among a thousand points: what comes out is counted
// again from the definition, in rational arithmetic.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "../support/cgal_triangles.h"
#include "../support/shapes.h"
#include "../support/walls.h"
#include "pipeline_check.h"
#include <gmpxx.h>
#include <gtest/gtest.h>

#include "hodt/order/edges.h"
#include "hodt/pipeline.h"
#include "hodt/pipeline/constrain.h"

namespace exhaustive {
namespace {

using hodt::Index;
using Edge = std::pair<int, int>;
using Corners = std::array<int, 3>;

Edge edge_of(int a, int b) {
  return std::minmax(a, b);
}

struct Place {
  mpq_class x, y;
};

mpq_class doubled_area(const Place& a, const Place& b, const Place& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

mpq_class squared(const Place& a, const Place& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/// The open disc of a triangle's circumcircle. No fourth point is on the circle.
class Disc {
 public:
  Disc(const Place& a, const Place& b, const Place& c) {
    const mpq_class d = 2 * doubled_area(a, b, c);
    const mpq_class bb = squared(a, b), cc = squared(a, c);
    centre_ = {a.x + ((c.y - a.y) * bb - (b.y - a.y) * cc) / d,
               a.y + ((b.x - a.x) * cc - (c.x - a.x) * bb) / d};
    radius_ = squared(a, centre_);
  }
  bool holds(const Place& p) const { return squared(p, centre_) < radius_; }
  /// The segment has a point in the disc.
  bool meets(const Place& p, const Place& q) const {
    if (holds(p) || holds(q)) return true;
    const mpq_class along = (centre_.x - p.x) * (q.x - p.x) + (centre_.y - p.y) * (q.y - p.y);
    const mpq_class length = squared(p, q);
    if (along <= 0 || along >= length) return false;
    const mpq_class area = doubled_area(p, q, centre_);
    return area * area < radius_ * length;
  }

 private:
  Place centre_;
  mpq_class radius_;
};

/// A triangulation, and the constraints that it has.
class Walk {
 public:
  Walk(std::span<const hodt::Point> points, std::vector<Corners> triangles, std::set<Edge> walls)
      : triangles_(std::move(triangles)), walls_(std::move(walls)) {
    for (const hodt::Point& p : points) places_.push_back({p.x, p.y});
    for (int t = 0; t < static_cast<int>(triangles_.size()); ++t)
      for (int i = 0; i < 3; ++i)
        at_[edge_of(triangles_[t][i], triangles_[t][(i + 1) % 3])].push_back(t);
  }
  const std::map<Edge, std::vector<int>>& edges() const { return at_; }
  const Corners& triangle(int t) const { return triangles_[t]; }
  std::size_t size() const { return triangles_.size(); }

  mpq_class area() const {
    mpq_class sum = 0;
    for (const auto& [a, b, c] : triangles_) {
      const mpq_class area = doubled_area(places_[a], places_[b], places_[c]);
      EXPECT_GT(area, 0);
      sum += area;
    }
    return sum;
  }

  /// The constrained order of triangle t: the vertices inside its disc, of the triangles met on the
  /// way over edges that are no walls and meet the disc.
  int order(int t) const {
    const Disc disc(places_[triangles_[t][0]], places_[triangles_[t][1]],
                    places_[triangles_[t][2]]);
    std::set<int> met{t}, inside;
    for (std::vector<int> next{t}; !next.empty();) {
      const int from = next.back();
      next.pop_back();
      const Corners& c = triangles_[from];
      for (const int v : c)
        if (std::count(triangles_[t].begin(), triangles_[t].end(), v) == 0 &&
            disc.holds(places_[v]))
          inside.insert(v);
      for (int i = 0; i < 3; ++i) {
        const Edge e = edge_of(c[i], c[(i + 1) % 3]);
        if (walls_.contains(e) || !disc.meets(places_[e.first], places_[e.second])) continue;
        for (const int beyond : at_.at(e))
          if (met.insert(beyond).second) next.push_back(beyond);
      }
    }
    return static_cast<int>(inside.size());
  }

 private:
  std::vector<Place> places_;
  std::vector<Corners> triangles_;
  std::set<Edge> walls_;
  std::map<Edge, std::vector<int>> at_;
};

struct Set {
  std::string name;
  hodt::PointSet points;
  hodt::Constraints constraints;
  std::set<Edge> walls;
};

/// Points without ties, with heights, and walls among them that pass through no third point.
Set set_of(std::string name, const support::Points& xy, double reach, std::uint64_t seed) {
  Set set{std::move(name), {xy, {}}, {}, {}};
  families::Random random(seed);
  for (std::size_t i = 0; i < xy.size(); ++i) set.points.z.push_back(random.integer(0, 50));
  // Points are numbered along the curve there, so that there are many short edges.
  const hodt::Delaunay d = hodt::delaunay(set.points);
  for (const auto& [u, v] : support::walls::random_edges(d.vertices.xy, 100, reach, seed)) {
    if (u == v) continue;
    const Index a = d.vertices.row[u], b = d.vertices.row[v];
    set.constraints.edges.push_back({a, b});
    set.walls.insert(edge_of(static_cast<int>(a), static_cast<int>(b)));
  }
  return set;
}

std::vector<Set> sets() {
  std::vector<Set> sets;
  sets.push_back(set_of("uniform", support::uniform(1000, 1), 0.3, 11));
  sets.push_back(set_of("noisy lattice", support::noisy_lattice(31, 31, 1e-6, 4), 8, 14));
  if (!slow()) return sets;
  sets.push_back(set_of("clustered", support::clustered(1000, 3), 0.3, 13));
  for (const std::uint64_t seed : {2, 3, 4, 5, 6})
    sets.push_back(
        set_of("uniform " + std::to_string(seed), support::uniform(1000, seed), 0.3, 10 + seed));
  return sets;
}

std::vector<Corners> corners_of(const std::vector<std::array<Index, 3>>& triangles) {
  std::vector<Corners> corners;
  for (const auto& [a, b, c] : triangles)
    corners.push_back({static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)});
  return corners;
}

/// Vertices without a lower neighbour, by (z, x, y).
std::size_t minima_of(const Walk& walk, const hodt::PointSet& points) {
  const auto key = [&](int v) { return std::tuple(points.z[v], points.xy[v].x, points.xy[v].y); };
  std::set<int> higher;
  for (const auto& [e, triangles] : walk.edges())
    higher.insert(key(e.first) > key(e.second) ? e.first : e.second);
  return points.size() - higher.size();
}

TEST(ConstraintsMedium, orders_walls_and_values_are_counted_again) {
  for (const Set& set : sets()) {
    SCOPED_TRACE(set.name);
    ASSERT_GT(set.walls.size(), 50u);
    const mpq_class hull =
        Walk(set.points.xy, corners_of(hodt::triangulate(set.points).tin.triangles), {}).area();
    double fewest = 1e9;
    for (const Index k : slow() ? std::vector<Index>{0, 1, 2, 4, 8} : std::vector<Index>{1, 4}) {
      for (const char* objective :
           {"min-local-minima", "min-sum-length", "min-max-angle", "min-sum-abn"}) {
        SCOPED_TRACE(std::string(objective) + " k " + std::to_string(k));
        const hodt::TriangulateResult result = hodt::triangulate(
            set.points, {.order = k, .objective = hodt::objective_from_name(objective)},
            set.constraints);
        const Walk walk(set.points.xy, corners_of(result.tin.triangles), set.walls);
        ASSERT_EQ(walk.area(), hull);
        for (const auto& [e, triangles] : walk.edges()) ASSERT_LE(triangles.size(), 2u);
        for (const Edge& wall : set.walls) ASSERT_TRUE(walk.edges().contains(wall));
        std::vector<std::size_t> histogram;
        for (int t = 0; t < static_cast<int>(walk.size()); ++t) {
          const auto order = static_cast<std::size_t>(walk.order(t));
          if (order >= histogram.size()) histogram.resize(order + 1);
          ++histogram[order];
        }
        ASSERT_EQ(histogram, result.report.order_histogram);
        ASSERT_LE(histogram.size(), std::size_t{k} + 1);
        if (std::string(objective) != "min-local-minima") continue;
        ASSERT_EQ(result.report.value->result, double(minima_of(walk, set.points)));
        ASSERT_LE(result.report.value->bound, result.report.value->result);
        ASSERT_LE(result.report.value->result, fewest);
        fewest = result.report.value->result;
      }
    }
  }
}

/// By Lemma 4, with CGAL's constrained Delaunay triangulation of the walls and one edge more, for
/// all edges from some vertices to those near them.
TEST(ConstraintsMedium, useful_edges_are_counted_again) {
  constexpr Index k = 3;
  const Set set = sets()[0];
  const std::span<const hodt::Point> xy = set.points.xy;
  hodt::Delaunay delaunay = hodt::delaunay(set.points);
  hodt::constrain(delaunay, set.points, set.constraints);
  std::map<Edge, Index> found;
  hodt::for_each_edge(hodt::DelaunayGraph(delaunay), hodt::EdgeClass::useful, k,
                      [&](std::span<const hodt::EdgeRecord> edges) {
                        for (const auto& [u, v, order] : edges)
                          found[edge_of(static_cast<int>(delaunay.vertices.row[u]),
                                        static_cast<int>(delaunay.vertices.row[v]))] = order;
                      });
  const std::vector<std::pair<int, int>> walls(set.walls.begin(), set.walls.end());
  const auto is_crossed = [&](int u, int v) {
    const std::array<hodt::VertexId, 2> edge{hodt::VertexId{Index(u)}, hodt::VertexId{Index(v)}};
    return std::any_of(walls.begin(), walls.end(), [&](const Edge& wall) {
      return support::walls::is_crossed(
          xy, edge, {hodt::VertexId{Index(wall.first)}, hodt::VertexId{Index(wall.second)}});
    });
  };
  std::size_t useful = 0, crossed = 0;
  for (int u = 0; u < 1000; u += 100) {
    std::vector<int> near;
    for (int v = 0; v < 1000; ++v)
      if (v != u) near.push_back(v);
    std::sort(near.begin(), near.end(), [&](int v, int w) {
      return std::hypot(xy[v].x - xy[u].x, xy[v].y - xy[u].y) <
             std::hypot(xy[w].x - xy[u].x, xy[w].y - xy[u].y);
    });
    near.resize(40);
    for (const int v : near) {
      const auto record = found.find(edge_of(u, v));
      if (is_crossed(u, v)) {
        ASSERT_TRUE(record == found.end()) << u << " " << v;
        ++crossed;
        continue;
      }
      std::vector<std::pair<int, int>> with = walls;
      with.emplace_back(u, v);
      const oracle::Triangles triangles = support::cgal_constrained(xy, with);
      const Walk walk(xy, {triangles.begin(), triangles.end()}, set.walls);
      int order = 0;
      for (const int t : walk.edges().at(edge_of(u, v))) order = std::max(order, walk.order(t));
      if (set.walls.contains(edge_of(u, v))) order = 0;
      ASSERT_EQ(record != found.end(), order <= static_cast<int>(k)) << u << " " << v;
      if (record == found.end()) continue;
      ASSERT_EQ(record->second, static_cast<Index>(order)) << u << " " << v;
      useful += order > 0;
    }
  }
  EXPECT_GT(useful, 15u);
  EXPECT_GT(crossed, 20u);
}

}  // namespace
}  // namespace exhaustive
