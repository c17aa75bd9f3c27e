#include "hodt/order/edges.h"

#include <algorithm>
#include <vector>

#include "hodt/base/parallel.h"
#include "hodt/base/stop.h"
#include "hodt/order/constrained/sight_order.h"
#include "hodt/order/constrained/sight_walk.h"
#include "hodt/order/fixed_edges.h"
#include "hodt/order/search/neighbourhood.h"
#include "hodt/order/search/pencil.h"
#include "hodt/order/useful_edges.h"

namespace hodt {

namespace {

/// By v. Mostly a handful, for which std::sort has too much to prepare.
void sort_by_end(std::span<EdgeRecord> records) {
  if (records.size() > 32)
    return std::sort(records.begin(), records.end(),
                     [](const EdgeRecord& a, const EdgeRecord& b) { return a.v < b.v; });
  for (std::size_t i = 1; i < records.size(); ++i) {
    const EdgeRecord record = records[i];
    std::size_t place = i;
    for (; place > 0 && record.v < records[place - 1].v; --place)
      records[place] = records[place - 1];
    records[place] = record;
  }
}

/// What finds k-OD edges where there are walls.
struct Sight {
  explicit Sight(const DelaunayGraph& graph) : walk(graph), order(graph) {}
  SightWalk walk;
  SightOrder order;
};

/// The edges of one class at one vertex after another.
class EdgesAt {
 public:
  /// Without a numbering vertices go by their own ids, and the lexicographically smaller end has
  /// the edge.
  EdgesAt(const DelaunayGraph& graph, EdgeClass edge_class, Index k, const Numbering* numbering,
          const Buffer<bool>& fixed, UsefulEdgeSearch& useful, PerThread<Sight>& sights)
      : graph_(graph),
        class_(edge_class),
        k_(k),
        numbering_(numbering),
        fixed_(fixed),
        useful_(useful),
        sights_(sights) {}

  /// Adds those from u to larger vertices.
  void add(VertexId u, std::vector<EdgeRecord>& records) {
    const auto number = [&](VertexId v) { return numbering_ ? numbering_->number[v] : Index(v); };
    const auto is_larger = [&](VertexId v) {
      return numbering_ ? number(v) > number(u)
                        : lexicographically_less(graph_.point(u), graph_.point(v));
    };
    const auto record = [&](VertexId v, Index order) {
      records.push_back({number(u), number(v), order});
    };
    switch (class_) {
      case EdgeClass::fixed:
        add_fixed(u, is_larger, record);
        break;
      case EdgeClass::kod:
        if (!graph_.has_walls()) {
          add_kod(u, is_larger, record);
          break;
        }
        add_kod_in_sight(u, is_larger, record);
        add_delaunay(u, is_larger, record);
        break;
      case EdgeClass::useful:
        if (k_ == 1) {
          add_first_order(u, is_larger, record);
          break;
        }
        for (const UsefulEdge& edge :
             numbering_ ? useful_.from(u, k_, is_larger) : useful_.to_larger(u, k_))
          record(edge.to, edge.order);
        [[fallthrough]];
      case EdgeClass::delaunay:
        add_delaunay(u, is_larger, record);
        break;
    }
  }

 private:
  template <class IsLarger, class Record>
  void add_kod(VertexId u, const IsLarger& is_larger, const Record& record) {
    Neighbourhood& around = useful_.neighbourhood();
    around.gather(u, k_);
    for (Index i = 0; i < around.size(); ++i) {
      check_stop();  // of large orders one vertex takes long
      if (around.least_order(i) > k_ || !is_larger(around.vertex(i))) continue;
      const Index order = around.pencil().edge_order(i, k_);
      if (order <= k_) record(around.vertex(i), order);
    }
  }

  /// All but the Delaunay edges.
  template <class IsLarger, class Record>
  void add_kod_in_sight(VertexId u, const IsLarger& is_larger, const Record& record) {
    Sight& sight = sights_.mine();
    sight.walk.from(u, k_, numbering_ ? Towards::all : Towards::larger, [&](VertexId v) {
      if (!is_larger(v)) return;
      const Index order = sight.order(u, v, k_);
      if (order <= k_) record(v, order);
    });
  }

  template <class IsLarger, class Record>
  void add_delaunay(VertexId u, const IsLarger& is_larger, const Record& record) {
    graph_.for_each_neighbour(u, [&](VertexId v) {
      if (is_larger(v)) record(v, 0);
    });
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
  const Numbering* const numbering_;
  const Buffer<bool>& fixed_;
  UsefulEdgeSearch& useful_;
  PerThread<Sight>& sights_;
};

using Sink = std::function<void(std::span<const EdgeRecord>)>;

void stream(const DelaunayGraph& graph, EdgeClass edge_class, Index k, const Numbering* numbering,
            const Sink& sink, const Deadline& deadline) {
  const bool asks_fixed =
      edge_class == EdgeClass::fixed || (edge_class == EdgeClass::useful && k == 1);
  const Buffer<bool> fixed = asks_fixed ? fixed_edges(graph, k, deadline) : Buffer<bool>();
  UsefulEdgeSearches searches(graph, k, deadline);
  PerThread<Sight> sights([&] {
    Sight sight(graph);
    sight.walk.end_at(deadline);
    return sight;
  });
  constexpr std::size_t kBatch = 1 << 15, kPiece = 1 << 9;
  const auto add = [&](std::size_t first, std::size_t last, std::vector<EdgeRecord>& records) {
    EdgesAt edges(graph, edge_class, k, numbering, fixed, searches.mine(), sights);
    for (std::size_t i = first; i < last; ++i) {
      const std::size_t before = records.size();
      if (numbering)
        for (const VertexId u : numbering->beginning_at(i)) edges.add(u, records);
      else
        edges.add(VertexId(Index(i)), records);
      sort_by_end({records.begin() + std::ptrdiff_t(before), records.end()});
    }
  };
  parallel_stream<EdgeRecord>(0, graph.xy.size(), kBatch, kPiece, add, sink);
}

}  // namespace

void for_each_edge(const DelaunayGraph& graph, EdgeClass edge_class, Index k, const Sink& sink,
                   const Deadline& deadline) {
  stream(graph, edge_class, k, nullptr, sink, deadline);
}

void for_each_edge(const DelaunayGraph& graph, EdgeClass edge_class, Index k,
                   const Numbering& numbering, const Sink& sink) {
  stream(graph, edge_class, k, &numbering, sink, {});
}

}  // namespace hodt
