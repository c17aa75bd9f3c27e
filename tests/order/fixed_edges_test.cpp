#include "hodt/order/fixed_edges.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "../support/convert.h"
#include "../support/shapes.h"
#include <gmpxx.h>
#include <gtest/gtest.h>

#include "hodt/base/parallel.h"
#include "hodt/order/first_order/first_order.h"
#include "hodt/order/segment_walk.h"
#include "hodt/order/useful_edges.h"

namespace hodt {
namespace {

// ---- Which edges are fixed ----

oracle::Edge edge_of(const TriangleMesh& mesh, HalfEdgeId h) {
  const int a = static_cast<int>(mesh.origin(h)), b = static_cast<int>(mesh.target(h));
  return {std::min(a, b), std::max(a, b)};
}

/// The fixed edges; checks that both half-edges of an edge say the same.
std::set<oracle::Edge> fixed_set(const DelaunayGraph& graph, Index k) {
  const Buffer<bool> fixed = fixed_edges(graph, k);
  EXPECT_EQ(fixed.size(), graph.mesh.halfedge_count());
  std::set<oracle::Edge> edges;
  for (Index i = 0; i < fixed.size(); ++i) {
    const HalfEdgeId h(i);
    if (graph.mesh.is_boundary(h))
      EXPECT_TRUE(fixed[h]) << "nothing crosses the hull";
    else
      EXPECT_EQ(fixed[h], fixed[graph.mesh.twin(h)]);
    if (fixed[h]) edges.insert(edge_of(graph.mesh, h));
  }
  return edges;
}

/// Useful edges that no other useful edge crosses.
std::set<oracle::Edge> fixed_by_definition(const oracle::Instance& instance, int k) {
  std::vector<oracle::Edge> useful;
  for (int u = 0; u < instance.size(); ++u)
    for (int v = u + 1; v < instance.size(); ++v) {
      const auto order = instance.useful_order_by_lemma(u, v);
      if (order && *order <= k) useful.push_back({u, v});
    }
  std::set<oracle::Edge> fixed;
  for (const auto& [u, v] : useful)
    if (std::none_of(useful.begin(), useful.end(), [&, u = u, v = v](const oracle::Edge& e) {
          return instance.segments_cross(u, v, e[0], e[1]);
        }))
      fixed.insert({u, v});
  return fixed;
}

class FixedFamilies : public testing::TestWithParam<families::Family> {};

TEST_P(FixedFamilies, are_the_useful_edges_that_none_crosses) {
  for (const int n : {4, 5, 7, 9, 12}) {
    const Delaunay d = delaunay(support::to_point_set(GetParam().make(n, n + 10)));
    const DelaunayGraph graph(d);
    const oracle::Instance instance(support::to_oracle(d.vertices.xy));
    for (int k = 0; k <= 6; ++k)
      ASSERT_EQ(fixed_set(graph, Index(k)), fixed_by_definition(instance, k))
          << "k " << k << ' ' << support::to_source(d.vertices.xy);
  }
}

TEST_P(FixedFamilies, are_what_all_triangulations_have_in_common) {
  for (const int n : {6, 8}) {
    const Delaunay d = delaunay(support::to_point_set(GetParam().make(n, n + 20)));
    const DelaunayGraph graph(d);
    const oracle::Instance instance(support::to_oracle(d.vertices.xy));
    const oracle::Catalogue catalogue(instance);
    for (const int k : {0, 1, 2, 3, 4, 6}) {
      const auto common = catalogue.edges_in_all(k);
      ASSERT_EQ(fixed_set(graph, Index(k)), std::set(common.begin(), common.end()))
          << "k " << k << ' ' << support::to_source(d.vertices.xy);
    }
  }
}

// ---- Faces ----

/// A component's number for each triangle: those joined across edges that are not fixed.
std::vector<Index> components(const TriangleMesh& mesh, const Buffer<bool>& fixed) {
  std::vector<Index> component(mesh.triangle_count(), kNone);
  Index count = 0;
  for (Index start = 0; start < component.size(); ++start) {
    if (component[start] != kNone) continue;
    std::vector<Index> waiting{start};
    component[start] = count;
    while (!waiting.empty()) {
      const HalfEdgeId first = TriangleMesh::halfedge(TriangleId(waiting.back()));
      waiting.pop_back();
      for (Index i = first; i < first + 3; ++i) {
        if (fixed[i]) continue;
        const Index beyond = TriangleMesh::triangle(mesh.twin(HalfEdgeId(i)));
        if (component[beyond] != kNone) continue;
        component[beyond] = count;
        waiting.push_back(beyond);
      }
    }
    ++count;
  }
  return component;
}

/// Same component, same face, and the other way round; the lists of triangles agree.
void expect_faces_are_components(const TriangleMesh& mesh, const Buffer<bool>& fixed,
                                 const FixedFaces& faces) {
  const auto component = components(mesh, fixed);
  std::map<Index, Index> face_of_component;
  std::vector<std::vector<TriangleId>> triangles(faces.size());
  for (Index t = 0; t < component.size(); ++t) {
    const Index face = faces.face_of(TriangleId(t));
    ASSERT_LT(face, faces.size());
    ASSERT_EQ(face_of_component.emplace(component[t], face).first->second, face);
    triangles[face].push_back(TriangleId(t));
  }
  ASSERT_EQ(face_of_component.size(), faces.size()) << "two components in a face";
  for (Index face = 0; face < faces.size(); ++face)
    ASSERT_TRUE(std::ranges::equal(faces.triangles(face), triangles[face]));
}

/// Exact: an inner walk around a tree of edges has area 0, and rounding must not make it positive.
mpq_class doubled_area(const DelaunayGraph& graph, const FixedFaces::Walk& walk) {
  mpq_class sum = 0;
  for (const HalfEdgeId h : walk) {
    const Point &a = graph.point(graph.mesh.origin(h)), &b = graph.point(graph.mesh.target(h));
    sum += mpq_class(a.x) * mpq_class(b.y) - mpq_class(b.x) * mpq_class(a.y);
  }
  return sum;
}

/// The side of the face that follows h: the first fixed edge when turning around the target of h
/// through triangles of the face.
HalfEdgeId following_side(const TriangleMesh& mesh, const Buffer<bool>& fixed, HalfEdgeId h) {
  HalfEdgeId side = TriangleMesh::next(h);
  while (!fixed[side]) side = TriangleMesh::next(mesh.twin(side));
  return side;
}

/// What is seen in the faces of a set, so that a test can say that it tested something.
struct Seen {
  std::size_t with_inner = 0;     ///< faces with an inner walk
  std::size_t with_isolated = 0;  ///< faces with a vertex that no fixed edge ends at
  std::size_t with_dangling = 0;  ///< faces that have both sides of an edge
};

class FaceCheck {
 public:
  FaceCheck(const DelaunayGraph& graph, Index k)
      : graph_(graph), fixed_(fixed_edges(graph, k)), faces_(graph, fixed_) {}

  void run(Seen& seen) {
    expect_faces_are_components(graph_.mesh, fixed_, faces_);
    std::size_t isolated = 0;
    for (Index face = 0; face < faces_.size(); ++face) {
      const FixedFaces::Boundary boundary = faces_.boundary(face);
      check_walks(face, boundary);
      check_isolated(face, boundary);
      check_count(face, boundary);
      check_areas(boundary);
      isolated += boundary.isolated.size();
      seen.with_inner += !boundary.inner.empty();
      seen.with_isolated += !boundary.isolated.empty();
      seen.with_dangling += has_both_sides(boundary);
      if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_EQ(isolated, vertices_without_fixed_edge());
  }

 private:
  static std::vector<FixedFaces::Walk> walks_of(const FixedFaces::Boundary& boundary) {
    std::vector<FixedFaces::Walk> walks = boundary.inner;
    walks.push_back(boundary.outer);
    return walks;
  }

  /// Each fixed half-edge of the face's triangles is in one walk, once; walks keep the face on
  /// their left, and have no vertex in common (or they would be one).
  void check_walks(Index face, const FixedFaces::Boundary& boundary) const {
    std::set<Index> expected, found;
    for (const TriangleId t : faces_.triangles(face))
      for (Index h = 3 * t; h < 3 * t + 3; ++h)
        if (fixed_[h]) expected.insert(h);
    std::set<Index> vertices_of_others;
    for (const FixedFaces::Walk& walk : walks_of(boundary)) {
      ASSERT_FALSE(walk.empty());
      std::set<Index> vertices;
      for (std::size_t i = 0; i < walk.size(); ++i) {
        ASSERT_TRUE(found.insert(walk[i]).second) << "walked twice";
        ASSERT_EQ(walk[(i + 1) % walk.size()], following_side(graph_.mesh, fixed_, walk[i]));
        vertices.insert(graph_.mesh.origin(walk[i]));
      }
      for (const Index v : vertices) ASSERT_TRUE(vertices_of_others.insert(v).second);
    }
    ASSERT_EQ(found, expected);
  }

  bool ends_a_fixed_edge(VertexId v) const {
    bool ends = false;
    for_each_outgoing(graph_.mesh, graph_.outgoing[v],
                      [&](HalfEdgeId h) { ends = ends || fixed_[h]; });
    return ends;
  }

  std::size_t vertices_without_fixed_edge() const {
    std::size_t count = 0;
    for (Index v = 0; v < graph_.xy.size(); ++v) count += !ends_a_fixed_edge(VertexId(v));
    return count;
  }

  void check_isolated(Index face, const FixedFaces::Boundary& boundary) const {
    std::set<Index> expected;
    for (const TriangleId t : faces_.triangles(face))
      for (const VertexId v : graph_.mesh.corners(t))
        if (!ends_a_fixed_edge(v)) expected.insert(v);
    const std::set<Index> found(boundary.isolated.begin(), boundary.isolated.end());
    ASSERT_EQ(found.size(), boundary.isolated.size()) << "listed twice";
    ASSERT_EQ(found, expected);
  }

  /// Euler. A face is open: T triangles and the E edges between them, no vertex. With c components
  /// of the boundary its characteristic is T - E = 2 - c. The triangles have 3T = S + 2E sides, S
  /// of them on the walks. So T = S + 2(c - 2), where an isolated vertex is a component.
  void check_count(Index face, const FixedFaces::Boundary& boundary) const {
    std::size_t sides = 0;
    for (const FixedFaces::Walk& walk : walks_of(boundary)) sides += walk.size();
    ASSERT_EQ(boundary.components(), 1 + boundary.inner.size() + boundary.isolated.size());
    ASSERT_EQ(faces_.triangles(face).size() + 4, sides + 2 * boundary.components());
  }

  void check_areas(const FixedFaces::Boundary& boundary) const {
    ASSERT_GT(doubled_area(graph_, boundary.outer), 0);
    for (const FixedFaces::Walk& walk : boundary.inner) ASSERT_LE(doubled_area(graph_, walk), 0);
  }

  bool has_both_sides(const FixedFaces::Boundary& boundary) const {
    std::set<Index> sides;
    for (const FixedFaces::Walk& walk : walks_of(boundary)) sides.insert(walk.begin(), walk.end());
    return std::any_of(sides.begin(), sides.end(),
                       [&](Index h) { return sides.contains(graph_.mesh.twin(HalfEdgeId(h))); });
  }

  const DelaunayGraph& graph_;
  const Buffer<bool> fixed_;
  const FixedFaces faces_;
};

TEST_P(FixedFamilies, cut_the_plane_into_faces) {
  Seen seen;
  for (const int n : {5, 9, 14, 24}) {
    if (GetParam().name == "wide_range" && n > 14) continue;
    for (std::uint64_t seed = 30; seed < 33; ++seed) {
      const Delaunay d = delaunay(support::to_point_set(GetParam().make(n, seed)));
      const DelaunayGraph graph(d);
      for (const Index k : {0, 1, 2, 4, 8}) {
        FaceCheck(graph, k).run(seen);
        ASSERT_FALSE(HasFailure()) << "k " << k << ' ' << support::to_source(d.vertices.xy);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, FixedFamilies, testing::ValuesIn(families::all()),
                         [](const auto& each) { return each.param.name; });

TEST(FixedFaces, of_large_sets_have_walks_that_obey_euler) {
  Seen seen;
  for (const support::Points& points :
       {support::uniform(2000, 1), support::uniform(2000, 2), support::clustered(1500, 3),
        support::lattice(40, 40), support::utm_lattice(30, 30),
        support::noisy_lattice(35, 35, 0.2, 4)}) {
    const Delaunay d = delaunay({points, {}});
    const DelaunayGraph graph(d);
    for (const Index k : {1, 4, 8, 10}) FaceCheck(graph, k).run(seen);
  }
  // Where there is none of a kind, nothing was tested.
  EXPECT_GT(seen.with_inner, 0u);
  EXPECT_GT(seen.with_isolated, 0u);
  EXPECT_GT(seen.with_dangling, 0u);
}

/// With no limit on the order, a diagonal of the hexagon crosses each edge to its middle, which
/// then stands alone in the only face.
TEST(FixedFaces, a_vertex_without_fixed_edges_is_a_component) {
  const Delaunay d =
      delaunay(PointSet{{{4, 0}, {2, 3}, {-2, 3}, {-4, 0}, {-2, -3}, {2, -3}, {0.5, 0.25}}, {}});
  const DelaunayGraph graph(d);
  const Buffer<bool> fixed = fixed_edges(graph, 7);
  const FixedFaces faces(graph, fixed);
  ASSERT_EQ(faces.size(), 1u);
  const FixedFaces::Boundary boundary = faces.boundary(0);
  EXPECT_EQ(boundary.outer.size(), 6u);
  EXPECT_TRUE(boundary.inner.empty());
  ASSERT_EQ(boundary.isolated.size(), 1u);
  EXPECT_EQ(graph.point(boundary.isolated[0]), (Point{0.5, 0.25}));
  EXPECT_EQ(boundary.components(), 2u);
}

TEST(FixedFaces, at_order_0_are_the_delaunay_triangles) {
  const Delaunay d = delaunay({support::lattice(20, 20), {}});
  const DelaunayGraph graph(d);
  const Buffer<bool> fixed = fixed_edges(graph, 0);
  EXPECT_TRUE(std::all_of(fixed.begin(), fixed.end(), [](bool f) { return f; }));
  EXPECT_EQ(FixedFaces(graph, fixed).size(), graph.mesh.triangle_count());
}

// ---- Larger sets ----

TEST(FixedEdges, are_those_that_no_segment_walk_crosses) {
  for (const support::Points& points :
       {support::uniform(3000, 5), support::lattice(45, 45), support::clustered(2000, 6)}) {
    const Delaunay d = delaunay({points, {}});
    const DelaunayGraph graph(d);
    UsefulEdgeSearch search(graph);
    for (const Index k : {2, 5, 9}) {
      Buffer<bool> expected(graph.mesh.halfedge_count(), true);
      for (Index u = 0; u < points.size(); ++u)
        for (const UsefulEdge& e : search.from(VertexId(u), k, [&](VertexId v) { return u < v; }))
          for_each_crossed(graph.mesh, graph.xy, graph.outgoing, VertexId(u), e.to,
                           [&](HalfEdgeId h) {
                             expected[h] = false;
                             expected[graph.mesh.twin(h)] = false;
                           });
      ASSERT_TRUE(std::ranges::equal(fixed_edges(graph, k), expected)) << "k " << k;
    }
  }
}

TEST(FixedEdges, at_order_1_are_all_but_the_flippable_ones) {
  for (const support::Points& points : {support::uniform(20000, 7), support::lattice(100, 90)}) {
    const Delaunay d = delaunay({points, {}});
    const DelaunayGraph graph(d);
    Buffer<bool> expected(graph.mesh.halfedge_count(), true);
    for (const HalfEdgeId h : first_order_edges(graph))
      expected[h] = expected[graph.mesh.twin(h)] = false;
    EXPECT_TRUE(std::ranges::equal(fixed_edges(graph, 1), expected));
  }
}

TEST(FixedEdges, are_the_same_on_any_number_of_threads_and_with_listed_neighbours) {
  for (const support::Points& points : {support::uniform(20000, 8), support::lattice(70, 70)}) {
    const Delaunay d = delaunay({points, {}});
    const DelaunayGraph plain(d);
    DelaunayGraph listed(d);
    listed.list_neighbours();
    const auto fixed = [&](const DelaunayGraph& graph, std::size_t threads) {
      const ThreadLimit limit(threads);
      return fixed_edges(graph, 5);
    };
    const Buffer<bool> expected = fixed(plain, 1);
    EXPECT_TRUE(std::ranges::equal(fixed(plain, 2), expected));
    EXPECT_TRUE(std::ranges::equal(fixed(listed, 2), expected));
  }
}

/// The shares that the documentation gives.
TEST(FixedEdges, share_in_uniform_points) {
  const std::map<Index, double> known{{1, 0.82}, {4, 0.50}, {8, 0.35}};
  const Delaunay d = delaunay({support::uniform(30000, 9), {}});
  const DelaunayGraph graph(d);
  for (const auto& [k, share] : known) {
    const Buffer<bool> fixed = fixed_edges(graph, k);
    const auto count = std::count(fixed.begin(), fixed.end(), true);
    EXPECT_NEAR(double(count) / double(fixed.size()), share, 0.01) << "k " << k;
  }
}

}  // namespace
}  // namespace hodt
