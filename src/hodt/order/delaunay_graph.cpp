#include "hodt/order/delaunay_graph.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"
#include "hodt/mesh/degrees.h"
#include "hodt/mesh/find_outgoing.h"

namespace hodt {

namespace {

using Edge = std::pair<VertexId, VertexId>;

/// The Delaunay edges of the points that are no hubs; both directions.
std::vector<Edge> edges_without(std::span<const Point> xy, const Buffer<bool>& hub) {
  std::vector<VertexId> kept;
  PointSet points;
  for (Index v = 0; v < xy.size(); ++v)
    if (!hub[v]) {
      kept.push_back(VertexId(v));
      points.xy.push_back(xy[v]);
    }
  std::vector<Edge> edges;
  const auto add = [&](VertexId a, VertexId b) {
    edges.emplace_back(a, b);
    edges.emplace_back(b, a);
  };
  try {
    const Delaunay rest = delaunay(points);
    const auto kept_vertex = [&](VertexId v) { return kept[rest.vertices.row[v]]; };
    for (Index i = 0; i < rest.mesh.halfedge_count(); ++i) {
      const HalfEdgeId h(i);
      if (rest.mesh.is_boundary(h) || h < rest.mesh.twin(h))
        add(kept_vertex(rest.mesh.origin(h)), kept_vertex(rest.mesh.target(h)));
    }
  } catch (const InputError&) {  // what is left lies on a line: each is joined to the next
    std::sort(kept.begin(), kept.end(),
              [&](VertexId a, VertexId b) { return lexicographically_less(xy[a], xy[b]); });
    for (std::size_t i = 1; i < kept.size(); ++i) add(kept[i - 1], kept[i]);
  }
  return edges;
}

}  // namespace

void OutgoingOnDemand::State::make() {
  const std::lock_guard<std::mutex> lock(making);
  if (is_made.load(std::memory_order_relaxed)) return;
  all = outgoing_halfedges(mesh);
  is_made.store(true, std::memory_order_release);
}

void DelaunayGraph::find_wall_ends() {
  wall_ends_ = Buffer<std::uint8_t>(xy.size(), 0);
  const auto count = [&](VertexId v) {
    wall_ends_[v] = static_cast<std::uint8_t>(std::min(wall_ends_[v] + 1, 2));
  };
  for (Index i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfEdgeId h(i);
    if (mesh.is_boundary(h))
      count(mesh.origin(h));  // the other end is the origin of the next one
    else if (walls[h] && h < mesh.twin(h))
      for (const VertexId end : {mesh.origin(h), mesh.target(h)}) count(end);
  }
}

bool DelaunayGraph::is_wall_at(VertexId a, VertexId b) const {
  const HalfEdgeId h = find_edge(mesh, outgoing, a, b);
  return h.valid() && walls[h];
}

void DelaunayGraph::list_neighbours(const Deadline& deadline) {
  constexpr std::size_t kGrain = 1 << 13;
  const std::size_t n = xy.size();
  NeighbourLists lists{Buffer<Index>(n + 1, 0), {}};
  const Buffer<Index> degrees = degrees_of(mesh);
  const Index largest = *std::max_element(degrees.begin(), degrees.end());
  std::partial_sum(degrees.begin(), degrees.end(), lists.first.begin() + 1);
  lists.vertices = Buffer<VertexId>(lists.first[n] + kUsualDegree);
  std::fill_n(lists.vertices.data() + lists.first[n], kUsualDegree, VertexId(0));
  parallel_for(0, n, kGrain, [&](std::size_t begin, std::size_t end) {
    VertexId* next = lists.vertices.data() + lists.first[begin];
    for (std::size_t v = begin; v < end; ++v)
      hodt::for_each_neighbour(mesh, outgoing[v], [&](VertexId w) { *next++ = w; });
  });
  lists_ = std::move(lists);
  // What goes around hubs would go through walls.
  if (largest > kHubDegree && !has_walls()) route_around_hubs(deadline);
}

void DelaunayGraph::list_neighbours_if_hubs(const Deadline& deadline) {
  const Buffer<Index> degrees = degrees_of(mesh);
  if (*std::max_element(degrees.begin(), degrees.end()) > kHubDegree) list_neighbours(deadline);
}

void DelaunayGraph::route_around_hubs(const Deadline& deadline) {
  const std::size_t n = xy.size();
  Buffer<bool> hub(n);
  for (Index v = 0; v < n; ++v) hub[v] = lists_.size(VertexId(v)) > kHubDegree;
  // Without the hubs others can turn into hubs; of points on a curve nearly all can, one after the
  // other, which is not worth it.
  constexpr int kMostRounds = 4;
  std::vector<Edge> edges;
  bool more = true;
  for (int round = 1; more; ++round) {
    edges = edges_without(xy, hub);
    std::vector<Index> degree(n, 0);
    for (const auto& [a, b] : edges) ++degree[a];
    more = false;
    if (round == kMostRounds || deadline.passed()) break;
    for (Index v = 0; v < n; ++v)
      if (degree[v] > kHubDegree) more = hub[v] = true;
  }

  // Hubs that neighbour each other are reached together.
  std::vector<std::vector<VertexId>> joined(n);
  std::vector<VertexId> group;
  Buffer<bool> grouped(n, false);
  for (Index v = 0; v < n; ++v) {
    if (!hub[v] || grouped[v]) continue;
    group.assign(1, VertexId(v));
    grouped[v] = true;
    for (std::size_t i = 0; i < group.size(); ++i)
      lists_.for_each(group[i], [&](VertexId w) {
        if (!hub[w] || grouped[w]) return;
        grouped[w] = true;
        group.push_back(w);
      });
    for (const VertexId w : group) joined[w] = group;
  }
  for (Index v = 0; v < n; ++v) {
    if (hub[v]) continue;
    const std::size_t before = edges.size();
    lists_.for_each(VertexId(v), [&](VertexId w) {
      if (!hub[w]) return;
      for (const VertexId other : joined[w]) edges.emplace_back(VertexId(v), other);
    });
    std::sort(edges.begin() + std::ptrdiff_t(before), edges.end());
    edges.erase(std::unique(edges.begin() + std::ptrdiff_t(before), edges.end()), edges.end());
  }

  onward_ = {Buffer<Index>(n + 1, 0), Buffer<VertexId>(edges.size())};
  for (const auto& [a, b] : edges) ++onward_.first[a + 1];
  std::partial_sum(onward_.first.begin(), onward_.first.end(), onward_.first.begin());
  std::vector<Index> next(onward_.first.begin(), onward_.first.end() - 1);
  for (const auto& [a, b] : edges) onward_.vertices[next[a]++] = b;
  hub_ = std::move(hub);
}

}  // namespace hodt
