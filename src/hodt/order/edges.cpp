#include "hodt/order/edges.h"

#include <algorithm>
#include <vector>

#include "hodt/base/parallel.h"
#include "hodt/order/fixed_edges.h"
#include "hodt/order/neighbourhood.h"
#include "hodt/order/pencil.h"
#include "hodt/order/useful_edges.h"

namespace hodt {

namespace {

/// The edges of one class at one vertex after another.
class EdgesAt {
 public:
  EdgesAt(const DelaunayGraph& graph, EdgeClass edge_class, Index k, const Numbering& numbering,
          const Buffer<bool>& fixed, UsefulEdgeSearch& useful)
      : graph_(graph),
        class_(edge_class),
        k_(k),
        numbering_(numbering),
        fixed_(fixed),
        useful_(useful) {}

  /// Adds those from u to vertices of larger numbers, sorted.
  void add(VertexId u, std::vector<EdgeRecord>& records) {
    const std::size_t before = records.size();
    const Index number = numbering_.number[u];
    const auto is_larger = [&](VertexId v) { return numbering_.number[v] > number; };
    const auto record = [&](VertexId v, Index order) {
      records.push_back({number, numbering_.number[v], order});
    };
    switch (class_) {
      case EdgeClass::fixed:
        add_fixed(u, is_larger, record);
        break;
      case EdgeClass::kod:
        add_kod(u, is_larger, record);
        break;
      case EdgeClass::useful:
        if (k_ == 1) {
          add_first_order(u, is_larger, record);
          break;
        }
        for (const UsefulEdge& edge : useful_.from(u, k_, is_larger)) record(edge.to, edge.order);
        [[fallthrough]];
      case EdgeClass::delaunay:
        graph_.for_each_neighbour(u, [&](VertexId v) {
          if (is_larger(v)) record(v, 0);
        });
        break;
    }
    std::sort(records.begin() + std::ptrdiff_t(before), records.end(),
              [](const EdgeRecord& a, const EdgeRecord& b) { return a.v < b.v; });
  }

 private:
  template <class IsLarger, class Record>
  void add_kod(VertexId u, const IsLarger& is_larger, const Record& record) {
    Neighbourhood& around = useful_.neighbourhood();
    around.gather(u, k_);
    for (Index i = 0; i < around.size(); ++i) {
      if (around.least_order(i) > k_ || !is_larger(around.vertex(i))) continue;
      const Index order = around.pencil().edge_order(i, k_);
      if (order <= k_) record(around.vertex(i), order);
    }
  }

  /// The Delaunay edges, and the flips of those opposite that are not fixed (Corollary 3).
  template <class IsLarger, class Record>
  void add_first_order(VertexId u, const IsLarger& is_larger, const Record& record) {
    const TriangleMesh& mesh = graph_.mesh;
    for_each_outgoing(mesh, graph_.outgoing[u], [&](HalfEdgeId h) {
      if (is_larger(mesh.target(h))) record(mesh.target(h), 0);
      const HalfEdgeId opposite = TriangleMesh::next(h), last = TriangleMesh::prev(h);
      if (mesh.is_boundary(last) && is_larger(mesh.origin(last))) record(mesh.origin(last), 0);
      if (fixed_[opposite]) return;
      const VertexId v = mesh.apex(mesh.twin(opposite));
      if (is_larger(v)) record(v, 1);
    });
  }

  template <class IsLarger, class Record>
  void add_fixed(VertexId u, const IsLarger& is_larger, const Record& record) {
    const TriangleMesh& mesh = graph_.mesh;
    for_each_outgoing(mesh, graph_.outgoing[u], [&](HalfEdgeId h) {
      if (fixed_[h] && is_larger(mesh.target(h))) record(mesh.target(h), 0);
      const HalfEdgeId last = TriangleMesh::prev(h);  // no half-edge leaves u along it
      if (mesh.is_boundary(last) && is_larger(mesh.origin(last))) record(mesh.origin(last), 0);
    });
  }

  const DelaunayGraph& graph_;
  const EdgeClass class_;
  const Index k_;
  const Numbering& numbering_;
  const Buffer<bool>& fixed_;
  UsefulEdgeSearch& useful_;
};

}  // namespace

void for_each_edge(const DelaunayGraph& graph, EdgeClass edge_class, Index k,
                   const Numbering& numbering,
                   const std::function<void(std::span<const EdgeRecord>)>& sink) {
  const bool asks_fixed =
      edge_class == EdgeClass::fixed || (edge_class == EdgeClass::useful && k == 1);
  const Buffer<bool> fixed = asks_fixed ? fixed_edges(graph, k) : Buffer<bool>();
  UsefulEdgeSearches searches(graph, k);
  constexpr std::size_t kBatch = 1 << 17, kPiece = 1 << 10;
  const auto add = [&](std::size_t first, std::size_t last, std::vector<EdgeRecord>& records) {
    EdgesAt edges(graph, edge_class, k, numbering, fixed, searches.mine());
    for (std::size_t i = first; i < last; ++i) edges.add(numbering.ascending[i], records);
  };
  parallel_stream<EdgeRecord>(0, graph.xy.size(), kBatch, kPiece, add, sink);
}

}  // namespace hodt
