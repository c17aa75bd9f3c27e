#include "hodt/order/hull.h"

#include <algorithm>
#include <string>
#include <vector>

#include "../support/convert.h"
#include "../support/shapes.h"
#include <gtest/gtest.h>

#include "hodt/geometry/predicates.h"
#include "hodt/order/circle_counter.h"
#include "hodt/order/constrained/constrained_triangulation.h"

namespace hodt {
namespace {

oracle::Triangles canonical(const std::vector<std::array<VertexId, 3>>& triangles) {
  oracle::Triangles result;
  for (const auto& [a, b, c] : triangles)
    result.push_back(
        support::canonical({static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)}));
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<std::array<VertexId, 3>> corners_of(const TriangleMesh& mesh,
                                                const std::vector<TriangleId>& triangles) {
  std::vector<std::array<VertexId, 3>> result;
  for (const TriangleId t : triangles) result.push_back(mesh.corners(t));
  return result;
}

bool adjacent(const TriangleMesh& mesh, TriangleId s, TriangleId t) {
  for (Index i = 0; i < 3; ++i) {
    const HalfEdgeId twin = mesh.twin(HalfEdgeId(TriangleMesh::halfedge(s) + i));
    if (twin.valid() && TriangleMesh::triangle(twin) == t) return true;
  }
  return false;
}

/// u, the walk, v: every step is an edge of a triangle of the hull.
bool is_walk(const DelaunayGraph& graph, VertexId u, std::vector<VertexId> walk, VertexId v) {
  walk.insert(walk.begin(), u);
  walk.push_back(v);
  for (std::size_t i = 0; i + 1 < walk.size(); ++i) {
    bool joined = false;
    graph.for_each_neighbour(walk[i], [&](VertexId w) { joined |= w == walk[i + 1]; });
    if (!joined) return false;
  }
  return true;
}

std::string problem(const DelaunayGraph& graph, const Hull& hull, VertexId u, VertexId v) {
  for (std::size_t i = 0; i + 1 < hull.triangles.size(); ++i)
    if (!adjacent(graph.mesh, hull.triangles[i], hull.triangles[i + 1])) return "not in order";
  for (const VertexId w : hull.left)
    if (orient(graph.point(u), graph.point(v), graph.point(w)) <= 0) return "not on the left";
  for (const VertexId w : hull.right)
    if (orient(graph.point(u), graph.point(v), graph.point(w)) >= 0) return "not on the right";
  if (hull.triangles.empty()) return hull.left.empty() && hull.right.empty() ? "" : "not empty";
  if (!is_walk(graph, u, hull.left, v) || !is_walk(graph, u, hull.right, v)) return "no walk";
  if (hull.left.size() + hull.right.size() != hull.triangles.size()) return "size of the walks";
  return "";
}

class Hulls : public testing::TestWithParam<families::Family> {};

/// Every edge of small sets: the hull by its definition, the triangulation as locking makes it, and
/// no order above the useful one.
TEST_P(Hulls, are_those_of_the_definition) {
  for (const int n : {6, 12, 22}) {
    if (GetParam().name == "wide_range" && n > 12) continue;
    const Delaunay d = delaunay(support::to_point_set(GetParam().make(n, n)));
    const DelaunayGraph graph(d);
    const oracle::Instance instance(support::to_oracle(d.vertices.xy));
    ConstrainedTriangulation locked(graph);
    CircleCounter counter(graph);
    std::vector<TriangleId> changed;
    for (int from = 0; from < instance.size(); ++from) {
      for (int to = 0; to < instance.size(); ++to) {
        if (from == to || !instance.is_segment_free(from, to)) continue;
        const VertexId u{Index(from)}, v{Index(to)};
        const std::string what = std::to_string(from) + " to " + std::to_string(to) + ' ' +
                                 support::to_source(d.vertices.xy);
        const Hull hull = hull_of_edge(graph, u, v);
        ASSERT_EQ(problem(graph, hull, u, v), "") << what;
        if (!hull.triangles.empty()) {
          ASSERT_EQ(canonical(corners_of(d.mesh, hull.triangles)), instance.hull_of_edge(from, to))
              << what;
        }
        const auto greedy = greedy_triangulation(graph, u, v);
        const auto before = locked.now();
        ASSERT_TRUE(locked.lock(u, v));
        locked.changed_since(before, changed);
        ASSERT_EQ(canonical(greedy), canonical(corners_of(locked.mesh(), changed))) << what;
        locked.roll_back(before);
        const int useful_order = instance.useful_order_by_lemma(from, to).value();
        for (const auto& [a, b, c] : greedy)
          ASSERT_LE(static_cast<int>(counter.count(a, b, c, kUnlimited)), useful_order) << what;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Hulls, testing::ValuesIn(families::all()),
                         [](const auto& each) { return each.param.name; });

/// Twice the area, exact for small whole coordinates.
long long area(const DelaunayGraph& graph, const std::vector<std::array<VertexId, 3>>& triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const Point &p = graph.point(a), &q = graph.point(b), &r = graph.point(c);
    EXPECT_GT(orient(p, q, r), 0);
    sum += (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  }
  return static_cast<long long>(sum);
}

bool has_repetition(std::vector<VertexId> walk) {
  std::sort(walk.begin(), walk.end());
  return std::adjacent_find(walk.begin(), walk.end()) != walk.end();
}

/// Long edges across many points: hulls with edges that dangle into them.
TEST(Hull, of_long_edges_keeps_area_and_number) {
  families::Random random(5);
  PointSet points;
  for (int i = 0; i < 600; ++i)
    points.xy.push_back({double(random.integer(0, 4000)), double(random.integer(0, 4000))});
  const Delaunay d = delaunay(points);
  const DelaunayGraph graph(d);
  ConstrainedTriangulation locked(graph);
  std::vector<TriangleId> changed;
  int with_repetition = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const VertexId u{Index(random.integer(0, 599) % d.vertices.size())};
    const VertexId v{Index(random.integer(0, 599) % d.vertices.size())};
    const auto blocks = [&](const Point& p) {
      const Point &a = graph.point(u), &b = graph.point(v);
      return p != a && p != b && orient(a, b, p) == 0;
    };
    if (u == v || std::any_of(graph.xy.begin(), graph.xy.end(), blocks)) continue;
    const Hull hull = hull_of_edge(graph, u, v);
    ASSERT_EQ(problem(graph, hull, u, v), "");
    const auto greedy = greedy_triangulation(graph, u, v);
    ASSERT_EQ(greedy.size(), hull.triangles.size());
    ASSERT_EQ(area(graph, greedy), area(graph, corners_of(d.mesh, hull.triangles)));
    const auto before = locked.now();
    ASSERT_TRUE(locked.lock(u, v));
    locked.changed_since(before, changed);
    ASSERT_EQ(canonical(greedy), canonical(corners_of(locked.mesh(), changed)));
    locked.roll_back(before);
    with_repetition += has_repetition(hull.left) || has_repetition(hull.right);
  }
  EXPECT_GT(with_repetition, 10);
}

}  // namespace
}  // namespace hodt
