#include "hodt/order/triangles.h"

#include <algorithm>
#include <tuple>
#include <vector>

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"
#include "hodt/geometry/predicates.h"
#include "hodt/order/circle_counter.h"
#include "hodt/order/edges.h"
#include "hodt/order/search/neighbourhood.h"
#include "hodt/order/search/pencil.h"

namespace hodt {

namespace {

using Sink = std::function<void(std::span<const TriangleRecord>)>;

bool is_less(const TriangleRecord& s, const TriangleRecord& t) {
  return std::tie(s.a, s.b, s.c) < std::tie(t.a, t.b, t.c);
}

/// Calls f(first, last, records) on pieces of the vertices in the order of their numbers, and
/// passes on what it adds, batch by batch.
template <class F>
void stream(std::size_t n, const Sink& sink, const F& f) {
  constexpr std::size_t kBatch = 1 << 15, kPiece = 1 << 8;
  parallel_stream<TriangleRecord>(0, n, kBatch, kPiece, f, sink);
}

/// k-OD triangles: from each vertex, those with the edges to its k-OD neighbours.
void for_each_kod_triangle(const DelaunayGraph& graph, Index k, const Numbering& numbering,
                           const Sink& sink, const Deadline& deadline) {
  PerThread<Neighbourhood> neighbourhoods([&] { return Neighbourhood(graph); });
  const auto add = [&](VertexId u, std::vector<TriangleRecord>& records) {
    deadline.check();
    Neighbourhood& around = neighbourhoods.mine();
    const std::size_t before = records.size();
    const auto number = [&](Index i) { return numbering.number[around.vertex(i)]; };
    const Index a = numbering.number[u];
    around.gather(u, k);
    for (Index i = 0; i < around.size(); ++i) {
      const Index b = number(i);
      if (b < a || around.least_order(i) > k) continue;
      around.pencil().for_each_triangle(i, k, [&](Index j, Index order) {
        if (number(j) > b) records.push_back({a, b, number(j), order});
      });
    }
    std::sort(records.begin() + std::ptrdiff_t(before), records.end(), is_less);
  };
  stream(graph.xy.size(), sink,
         [&](std::size_t first, std::size_t last, std::vector<TriangleRecord>& records) {
           for (std::size_t i = first; i < last; ++i) add(numbering.ascending[i], records);
         });
}

/// All useful edges, to both ends: lists of (other end, order), by the numbers of the vertices.
struct UsefulLists {
  struct End {
    Index to, order;
  };
  std::vector<std::size_t> first;
  std::vector<End> ends;

  std::span<const End> of(Index place) const {
    return {ends.data() + first[place], ends.data() + first[place + 1]};
  }
};

/// Lists by a vertex's place among the numbers; each list sorted.
UsefulLists useful_lists(const DelaunayGraph& graph, Index k, const Numbering& numbering,
                         const std::vector<Index>& place_of_number, const Deadline& deadline) {
  std::vector<EdgeRecord> edges;
  const auto add = [&](std::span<const EdgeRecord> piece) {
    for (const auto& [u, v, order] : piece)
      edges.push_back({numbering.number[VertexId(u)], numbering.number[VertexId(v)], order});
  };
  for_each_edge(graph, EdgeClass::useful, k, add, deadline);
  UsefulLists lists;
  lists.first.assign(graph.xy.size() + 1, 0);
  for (const EdgeRecord& e : edges) {
    ++lists.first[place_of_number[e.u] + 1];
    ++lists.first[place_of_number[e.v] + 1];
  }
  for (std::size_t i = 1; i < lists.first.size(); ++i) lists.first[i] += lists.first[i - 1];
  lists.ends.resize(lists.first.back());
  std::vector<std::size_t> next(lists.first.begin(), lists.first.end() - 1);
  for (const EdgeRecord& e : edges) lists.ends[next[place_of_number[e.v]]++] = {e.u, e.order};
  for (const EdgeRecord& e : edges) lists.ends[next[place_of_number[e.u]]++] = {e.v, e.order};
  parallel_for(0, graph.xy.size(), 1 << 10, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      std::sort(lists.ends.begin() + std::ptrdiff_t(lists.first[i]),
                lists.ends.begin() + std::ptrdiff_t(lists.first[i + 1]),
                [](const auto& a, const auto& b) { return a.to < b.to; });
  });
  return lists;
}

/// Valid triangles: three useful edges, and of what their circle holds nothing in the triangle.
class ValidTriangles {
 public:
  ValidTriangles(const DelaunayGraph& graph, Index k, const Numbering& numbering,
                 const Deadline& deadline)
      : graph_(graph),
        k_(k),
        numbering_(numbering),
        deadline_(deadline),
        place_of_number_(places(numbering)),
        lists_(useful_lists(graph, k, numbering, place_of_number_, deadline)) {}

  void add(CircleCounter& counter, std::size_t place, std::vector<TriangleRecord>& records) const {
    const VertexId u = numbering_.ascending[place];
    const Index a = numbering_.number[u];
    const auto from_u = lists_.of(Index(place));
    for (const auto& [b, order_ab] : above(a, from_u)) {
      deadline_.check();
      const VertexId v = vertex(b);
      const Index least = order_ab;  // a structured binding is not to be captured
      for_each_in_both(above(b, from_u), above(b, lists_.of(place_of_number_[b])),
                       [&](Index c, Index order_ac, Index order_bc) {
                         const Index inside = order_if_empty(counter, u, v, vertex(c));
                         if (inside <= k_)
                           records.push_back({a, numbering_.number[v], c,
                                              std::max({inside, least, order_bc, order_ac})});
                       });
    }
  }

 private:
  using Ends = std::span<const UsefulLists::End>;

  static Ends::iterator first_from(Index number, Ends::iterator begin, Ends::iterator end) {
    return std::lower_bound(begin, end, number,
                            [](const UsefulLists::End& e, Index n) { return e.to < n; });
  }
  static Ends above(Index number, const Ends& ends) {
    return {first_from(number + 1, ends.begin(), ends.end()), ends.end()};
  }

  /// Calls f(number, order in the one list, order in the other), ascending. Where one list is far
  /// longer than the other, as a hub's is, it is not gone through.
  template <class F>
  static void for_each_in_both(const Ends& ends, const Ends& others, const F& f) {
    if (ends.size() <= others.size()) return go_through(ends, others, f);
    go_through(others, ends,
               [&](Index to, Index in_others, Index in_ends) { f(to, in_ends, in_others); });
  }
  template <class F>
  static void go_through(const Ends& ends, const Ends& others, const F& f) {
    constexpr std::size_t kFew = 8;
    auto x = others.begin();
    for (const auto& [to, order] : ends) {
      if (others.size() > kFew * ends.size())
        x = first_from(to, x, others.end());
      else
        while (x != others.end() && x->to < to) ++x;
      if (x == others.end()) break;
      if (x->to == to) f(to, order, x->order);
    }
  }

  static std::vector<Index> places(const Numbering& numbering) {
    std::vector<Index> places(
        numbering.ascending.empty() ? 0 : numbering.number[*(numbering.ascending.end() - 1)] + 1,
        kNone);
    for (Index i = 0; i < numbering.ascending.size(); ++i)
      places[numbering.number[numbering.ascending[i]]] = i;
    return places;
  }
  VertexId vertex(Index number) const { return numbering_.ascending[place_of_number_[number]]; }

  /// The number of points inside the circle; more than k also if one of them is in the triangle, or
  /// if there is no triangle. (Points on a side would be between the ends of a useful edge.)
  Index order_if_empty(CircleCounter& counter, VertexId u, VertexId v, VertexId w) const {
    const int turn = orient(graph_.point(u), graph_.point(v), graph_.point(w));
    if (turn == 0) return k_ + 1;
    if (turn < 0) std::swap(v, w);
    const Index inside = counter.count(u, v, w, k_);
    if (inside > k_) return inside;
    const Point &a = graph_.point(u), &b = graph_.point(v), &c = graph_.point(w);
    for (const VertexId p : counter.inside()) {
      const Point& q = graph_.point(p);
      if (orient(a, b, q) > 0 && orient(b, c, q) > 0 && orient(c, a, q) > 0) return k_ + 1;
    }
    return inside;
  }

  const DelaunayGraph& graph_;
  const Index k_;
  const Numbering& numbering_;
  const Deadline deadline_;
  const std::vector<Index> place_of_number_;
  const UsefulLists lists_;
};

void for_each_valid_triangle(const DelaunayGraph& graph, Index k, const Numbering& numbering,
                             const Sink& sink, const Deadline& deadline) {
  const ValidTriangles triangles(graph, k, numbering, deadline);
  PerThread<CircleCounter> counters([&] { return CircleCounter(graph); });
  stream(graph.xy.size(), sink,
         [&](std::size_t first, std::size_t last, std::vector<TriangleRecord>& records) {
           CircleCounter& counter = counters.mine();
           for (std::size_t i = first; i < last; ++i) triangles.add(counter, i, records);
         });
}

}  // namespace

void for_each_triangle(const DelaunayGraph& graph, TriangleClass triangle_class, Index k,
                       const Numbering& numbering, const Sink& sink, const Deadline& deadline) {
  if (triangle_class == TriangleClass::kod && graph.has_walls())
    throw ParameterError("k-OD triangles are not found with constraints; valid ones are");
  if (triangle_class == TriangleClass::kod)
    for_each_kod_triangle(graph, k, numbering, sink, deadline);
  else
    for_each_valid_triangle(graph, k, numbering, sink, deadline);
}

}  // namespace hodt
