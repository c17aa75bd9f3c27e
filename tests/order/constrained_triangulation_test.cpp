#include "hodt/order/constrained/constrained_triangulation.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "../support/connectivity_problem.h"
#include "../support/convert.h"
#include "../support/shapes.h"
#include "../support/triangulation_problems.h"
#include <gtest/gtest.h>

#include "hodt/geometry/predicates.h"
#include "hodt/order/useful_edges.h"

namespace hodt {
namespace {

using Edges = std::vector<std::pair<Index, Index>>;

bool has_edge(const TriangleMesh& mesh, Index a, Index b) {
  for (Index i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfEdgeId h(i);
    if (mesh.origin(h) == a && mesh.target(h) == b) return true;
    if (mesh.origin(h) == b && mesh.target(h) == a) return true;
  }
  return false;
}

/// Everything that must hold whatever is locked: a triangulation of all points, every edge that is
/// not locked locally Delaunay, the locked edges there, the outgoing half-edges as promised.
std::string problem(const DelaunayGraph& graph, const ConstrainedTriangulation& triangulation,
                    const Edges& locked) {
  const TriangleMesh& mesh = triangulation.mesh();
  if (auto p = connectivity_problem(mesh, Surface::disk); !p.empty()) return p;
  if (auto p = embedding_problem(graph.xy, mesh); !p.empty()) return p;
  const auto& xy = graph.xy;
  for (Index i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfEdgeId h(i);
    if (mesh.is_boundary(h)) continue;
    const VertexId a = mesh.origin(h), b = mesh.target(h);
    const bool is_locked = std::any_of(locked.begin(), locked.end(), [&](const auto& e) {
      return (e.first == a && e.second == b) || (e.first == b && e.second == a);
    });
    if (is_locked != triangulation.is_locked(a, b)) return "is_locked";
    if (!is_locked && in_circle(xy[a], xy[b], xy[mesh.apex(h)], xy[mesh.apex(mesh.twin(h))]))
      return "an edge that is not locked and not Delaunay";
  }
  for (const auto& [a, b] : locked) {
    if (!has_edge(mesh, a, b)) return "a locked edge is missing";
    if (!triangulation.owns_locked_edge(VertexId(a))) return "owns_locked_edge";
  }
  for (Index v = 0; v < xy.size(); ++v) {
    const HalfEdgeId h = triangulation.outgoing(VertexId(v));
    if (mesh.origin(h) != v) return "outgoing leaves another vertex";
    const bool on_hull = mesh.is_boundary(outgoing_halfedges(mesh)[v]);
    if (mesh.is_boundary(h) != on_hull) return "outgoing of a boundary vertex is not the boundary";
  }
  return "";
}

TEST(ConstrainedTriangulation, starts_as_the_delaunay_triangulation) {
  const Delaunay d = delaunay({support::uniform(50, 1), {}});
  const DelaunayGraph graph(d);
  ConstrainedTriangulation triangulation(graph);
  EXPECT_TRUE(support::same_arrays(triangulation.mesh(), d.mesh));
  EXPECT_EQ(problem(graph, triangulation, {}), "");
  for (Index t = 0; t < d.mesh.triangle_count(); ++t)
    EXPECT_TRUE(triangulation.is_original(TriangleId(t)));
  for (Index v = 0; v < 50; ++v) EXPECT_FALSE(triangulation.owns_locked_edge(VertexId(v)));
  EXPECT_TRUE(support::same_arrays(std::move(triangulation).take_mesh(), d.mesh));
}

class Locking : public testing::TestWithParam<families::Family> {};

/// The paper's greedy triangulation of one hull, for every possible edge.
TEST_P(Locking, one_edge_changes_its_hull_alone) {
  for (const int n : {6, 12, 22}) {
    if (GetParam().name == "wide_range" && n > 12) continue;
    const Delaunay d = delaunay(support::to_point_set(GetParam().make(n, n)));
    const DelaunayGraph graph(d);
    const oracle::Instance instance(support::to_oracle(d.vertices.xy));
    const oracle::Triangles original = support::triangles_of(d.mesh);
    ConstrainedTriangulation triangulation(graph);
    for (int u = 0; u < instance.size(); ++u) {
      for (int v = 0; v < instance.size(); ++v) {
        if (u == v || !instance.is_segment_free(u, v)) continue;
        const std::string what = std::to_string(u) + " to " + std::to_string(v) + ' ' +
                                 support::to_source(d.vertices.xy);
        const auto before = triangulation.now();
        ASSERT_TRUE(triangulation.lock(VertexId{Index(u)}, VertexId{Index(v)})) << what;
        ASSERT_TRUE(triangulation.last_hull_was_original());
        ASSERT_EQ(problem(graph, triangulation, {{u, v}}), "") << what;
        const oracle::Triangles now = support::triangles_of(triangulation.mesh());
        ASSERT_EQ(instance.why_not_triangulation(now), "") << what;
        // The useful order of an edge is at most that of this triangulation, by definition, and at
        // least by Lemma 4.
        ASSERT_EQ(instance.order(now), instance.useful_order_by_lemma(u, v)) << what;

        oracle::Triangles gone;
        std::set_difference(original.begin(), original.end(), now.begin(), now.end(),
                            std::back_inserter(gone));
        oracle::Triangles hull = instance.hull_of_edge(u, v);
        const bool was_edge = has_edge(d.mesh, Index(u), Index(v));
        if (was_edge) hull.clear();
        ASSERT_EQ(gone, hull) << what;

        std::vector<TriangleId> changed;
        triangulation.changed_since(before, changed);
        ASSERT_EQ(changed.size(), hull.size()) << what;
        ASSERT_TRUE(std::is_sorted(changed.begin(), changed.end()));
        for (Index t = 0; t < d.mesh.triangle_count(); ++t) {
          const bool listed = std::binary_search(changed.begin(), changed.end(), TriangleId(t));
          ASSERT_EQ(listed, !triangulation.is_original(TriangleId(t))) << what;
        }

        triangulation.release(VertexId{Index(u)});
        ASSERT_EQ(support::triangles_of(triangulation.mesh()), original) << what;
        ASSERT_EQ(problem(graph, triangulation, {}), "") << what;
        triangulation.roll_back(before);
        ASSERT_TRUE(support::same_arrays(triangulation.mesh(), d.mesh)) << what;
      }
    }
  }
}

/// Random edges locked and released: the triangles depend only on which edges are locked.
TEST_P(Locking, any_history_gives_the_same_triangles) {
  families::Random random(7);
  const int n = GetParam().name == "wide_range" ? 12 : 30;
  const Delaunay d = delaunay(support::to_point_set(GetParam().make(n, 77)));
  const DelaunayGraph graph(d);
  const oracle::Instance instance(support::to_oracle(d.vertices.xy));
  const int size = instance.size();
  ConstrainedTriangulation triangulation(graph);
  Edges locked;
  struct Past {
    ConstrainedTriangulation::Moment moment;
    TriangleMesh mesh;
    Edges locked;
  };
  std::vector<Past> past;
  int locks = 0, refusals = 0, releases = 0;
  for (int step = 0; step < 300; ++step) {
    const int choice = random.integer(0, 9);
    if (choice < 6) {
      const int u = random.integer(0, size - 1), v = random.integer(0, size - 1);
      if (u == v || !instance.is_segment_free(u, v)) continue;
      const VertexId from{Index(u)}, to{Index(v)};
      if (triangulation.owns_locked_edge(from)) continue;
      Edges crossed;
      for (const auto& [a, b] : locked)
        if (instance.segments_cross(u, v, int(a), int(b))) crossed.emplace_back(a, b);
      const TriangleMesh before = triangulation.mesh();
      const bool done = triangulation.lock(from, to);
      ASSERT_EQ(done, crossed.empty());
      if (done)
        locked.emplace_back(u, v);
      else
        ASSERT_TRUE(support::same_arrays(before, triangulation.mesh()));
      ++(done ? locks : refusals);
    } else if (choice < 8 && !locked.empty()) {
      const std::size_t which = random.bits() % locked.size();
      triangulation.release(VertexId(locked[which].first));
      locked.erase(locked.begin() + std::ptrdiff_t(which));
      ++releases;
    } else if (choice == 8) {
      past.push_back({triangulation.now(), triangulation.mesh(), locked});
    } else if (!past.empty()) {
      const std::size_t which = random.bits() % past.size();
      triangulation.roll_back(past[which].moment);
      locked = past[which].locked;
      ASSERT_TRUE(support::same_arrays(triangulation.mesh(), past[which].mesh));
      past.erase(past.begin() + std::ptrdiff_t(which) + 1, past.end());
    }
    ASSERT_EQ(problem(graph, triangulation, locked), "") << support::to_source(d.vertices.xy);
    if (step % 20 != 0) continue;
    ConstrainedTriangulation fresh(graph);
    Edges shuffled = locked;
    random.shuffle(shuffled);
    for (const auto& [a, b] : shuffled) ASSERT_TRUE(fresh.lock(VertexId(a), VertexId(b)));
    ASSERT_EQ(support::triangles_of(fresh.mesh()), support::triangles_of(triangulation.mesh()));
  }
  EXPECT_GT(locks, 5);
  EXPECT_GT(releases, 5);
  while (!locked.empty()) {
    triangulation.release(VertexId(locked.back().first));
    locked.pop_back();
  }
  EXPECT_EQ(support::triangles_of(triangulation.mesh()), support::triangles_of(d.mesh));
}

INSTANTIATE_TEST_SUITE_P(All, Locking, testing::ValuesIn(families::all()),
                         [](const auto& each) { return each.param.name; });

TEST(ConstrainedTriangulation, both_ends_may_own_the_same_edge) {
  const Delaunay d = delaunay(PointSet{{{0, 0}, {4, 0}, {2, 1}, {2, -1}}, {}});
  const DelaunayGraph graph(d);
  ConstrainedTriangulation triangulation(graph);
  Index left = 0, right = 0;
  for (Index v = 0; v < 4; ++v) {
    if (graph.xy[v].x == 0) left = v;
    if (graph.xy[v].x == 4) right = v;
  }
  ASSERT_FALSE(has_edge(d.mesh, left, right));
  ASSERT_TRUE(triangulation.lock(VertexId(left), VertexId(right)));
  ASSERT_TRUE(triangulation.lock(VertexId(right), VertexId(left)));
  triangulation.release(VertexId(left));
  EXPECT_TRUE(has_edge(triangulation.mesh(), left, right));
  EXPECT_TRUE(triangulation.is_locked(VertexId(left), VertexId(right)));
  triangulation.release(VertexId(right));
  EXPECT_FALSE(has_edge(triangulation.mesh(), left, right));
  EXPECT_FALSE(triangulation.is_locked(VertexId(left), VertexId(right)));
}

TEST(ConstrainedTriangulation, a_hull_on_changed_triangles_is_not_original) {
  const Delaunay d = delaunay({support::uniform(400, 3), {}});
  const DelaunayGraph graph(d);
  UsefulEdgeSearch search(graph);
  ConstrainedTriangulation triangulation(graph);
  int original = 0, changed = 0;
  for (Index u = 0; u < 400; ++u) {
    const auto found = search.from(VertexId(u), 6, [](VertexId) { return true; });
    if (found.empty()) continue;
    std::vector<TriangleId> before;
    triangulation.changed_since(0, before);
    const auto moment = triangulation.now();
    if (!triangulation.lock(VertexId(u), found.back().to)) continue;
    std::vector<TriangleId> hull;
    triangulation.changed_since(moment, hull);
    bool met = false;
    for (const TriangleId t : hull) met |= std::binary_search(before.begin(), before.end(), t);
    if (triangulation.last_hull_was_original()) {
      ASSERT_FALSE(met);
      for (const TriangleId t : hull) ASSERT_FALSE(triangulation.is_original(t));
    }
    ++(triangulation.last_hull_was_original() ? original : changed);
    ASSERT_TRUE(met || triangulation.last_hull_was_original());
  }
  EXPECT_GT(original, 20);
  EXPECT_GT(changed, 20);
}

TEST(ConstrainedTriangulation, commit_forgets_and_keeps) {
  const Delaunay d = delaunay({support::lattice(12, 12), {}});
  const DelaunayGraph graph(d);
  UsefulEdgeSearch search(graph);
  ConstrainedTriangulation triangulation(graph);
  Edges locked;
  for (Index u = 0; u < 144; u += 7) {
    const auto found = search.from(VertexId(u), 3, [](VertexId) { return true; });
    if (!found.empty() && triangulation.lock(VertexId(u), found[0].to))
      locked.emplace_back(u, found[0].to);
  }
  ASSERT_GT(locked.size(), 5u);
  triangulation.commit();
  EXPECT_EQ(triangulation.now(), 0u);
  const TriangleMesh kept = triangulation.mesh();
  triangulation.release(VertexId(locked[0].first));
  triangulation.roll_back(0);
  EXPECT_TRUE(support::same_arrays(kept, triangulation.mesh()));
  EXPECT_EQ(problem(graph, triangulation, locked), "");
}

}  // namespace
}  // namespace hodt
