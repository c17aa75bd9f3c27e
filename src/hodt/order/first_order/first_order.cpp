#include "hodt/order/first_order/first_order.h"

#include <array>

#include "hodt/base/parallel.h"
#include "hodt/geometry/predicates.h"
#include "hodt/order/circle_counter.h"
#include "hodt/order/first_order/flip_circles.h"
#include "hodt/order/first_order/nearest_beyond.h"

namespace hodt {

namespace {

/// The flippable edges of a run of triangles.
class Finder {
 public:
  Finder(const DelaunayGraph& graph, FlipCircles& circles, const KeepWanted& keep_wanted,
         std::vector<HalfEdgeId>& found)
      : graph_(graph),
        circles_(circles),
        keep_wanted_(keep_wanted),
        found_(found),
        nearest_(graph) {}

  void find(std::size_t first, std::size_t last) {
    nearest_.judge(first, last - first);
    constexpr std::size_t kRoom = 3;  // a triangle's edges
    for (std::size_t t = first; t < last; ++t) {
      add_edges(TriangleId(static_cast<Index>(t)));
      if (size_ + kRoom > edges_.size()) take_flippable();
    }
    take_flippable();
  }

 private:
  /// Those of a triangle that the nearest points leave possible. What they tell is a matter of
  /// chance: no branches.
  void add_edges(TriangleId t) {
    for (Index e = 0; e < 3; ++e) {
      const HalfEdgeId h(TriangleMesh::halfedge(t) + e), twin = graph_.mesh.twin(h);
      if (graph_.is_wall(h)) continue;
      edges_[size_] = h;
      size_ += std::size_t(h < twin) & std::size_t(twin.valid()) &
               std::size_t(!nearest_.rule_out_from_inside(t, e));
    }
  }
  void take_flippable();

  static constexpr std::size_t kBatch = 248;

  const DelaunayGraph& graph_;
  FlipCircles& circles_;
  const KeepWanted& keep_wanted_;
  std::vector<HalfEdgeId>& found_;
  NearestBeyond nearest_;
  std::array<HalfEdgeId, kBatch> edges_;
  std::size_t size_ = 0;
};

void Finder::take_flippable() {
  std::size_t possible = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    edges_[possible] = edges_[i];
    possible += std::size_t(!nearest_.rule_out_from_outside(edges_[i]));
  }
  size_ = 0;
  if (keep_wanted_) possible = keep_wanted_({edges_.data(), possible});
  std::array<bool, kBatch> is_flippable;
  circles_.hold_one_each({edges_.data(), possible}, is_flippable.data());
  for (std::size_t i = 0; i < possible; ++i)
    if (is_flippable[i]) found_.push_back(edges_[i]);
}

}  // namespace

bool is_first_order_flippable(const DelaunayGraph& graph, HalfEdgeId h) {
  const TriangleMesh& mesh = graph.mesh;
  if (mesh.is_boundary(h) || graph.is_wall(h)) return false;
  // The diagonal u v crosses the edge s y; s is to the left of u v, so s, u, y, v go around.
  const HalfEdgeId twin = mesh.twin(h);
  const VertexId s = mesh.origin(h), y = mesh.origin(twin), v = mesh.apex(h), u = mesh.apex(twin);
  const Point &pu = graph.point(u), &pv = graph.point(v);
  const bool is_convex = orient(pu, pv, graph.point(s)) > 0 && orient(pv, pu, graph.point(y)) > 0;
  return is_convex && holds_origin_only(graph, {u, v, s}, twin) &&
         holds_origin_only(graph, {v, u, y}, h);
}

std::vector<HalfEdgeId> first_order_edges(const DelaunayGraph& graph,
                                          const KeepWanted& keep_wanted) {
  const std::size_t triangles = graph.mesh.triangle_count();
  FlipCircles circles(graph);
  const auto find = [&](std::size_t first, std::size_t last, std::vector<HalfEdgeId>& found) {
    Finder(graph, circles, keep_wanted, found).find(first, last);
  };
  // Pieces that stay in the cache.
  return parallel_collect<HalfEdgeId>(0, triangles, NearestBeyond::kMostTriangles, find);
}

}  // namespace hodt
