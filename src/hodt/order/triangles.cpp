#include "hodt/order/triangles.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

#include "hodt/base/parallel.h"
#include "hodt/geometry/predicates.h"
#include "hodt/order/circle_counter.h"
#include "hodt/order/edge_lists.h"
#include "hodt/order/open_triangles.h"
#include "hodt/order/search/neighbourhood.h"
#include "hodt/order/search/pencil.h"

namespace hodt {

namespace {

using Sink = std::function<void(std::span<const TriangleRecord>)>;
using Corners = std::array<VertexId, 3>;

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

/// Triangles with three sides of a list, as far as judge(counter, corners) has an order for them:
/// `corners` are counter-clockwise.
template <class Judge>
class TrianglesOfSides {
 public:
  TrianglesOfSides(const DelaunayGraph& graph, std::span<const EdgeRecord> sides, Index k,
                   const Numbering& numbering, const Deadline& deadline, const Judge& judge)
      : graph_(graph),
        k_(k),
        numbering_(numbering),
        deadline_(deadline),
        lists_(sides, numbering),
        judge_(judge) {}

  /// Adds those whose first corner is at this place of the ascending numbers.
  void add(CircleCounter& counter, Index a, std::vector<TriangleRecord>& records) const {
    const Ends from_a = lists_.of(a);
    for (const auto& [to, order_ab] : above(a, from_a)) {
      deadline_.check();
      const Index b = to, least = order_ab;  // a structured binding is not to be captured
      for_each_in_both(
          above(b, from_a), above(b, lists_.of(b)), [&](Index c, Index order_ac, Index order_bc) {
            const Index order = order_of(counter, a, b, c, std::max({least, order_ac, order_bc}));
            if (order <= k_) records.push_back({number(a), number(b), number(c), order});
          });
    }
  }

 private:
  using End = EdgeLists::End;
  using Ends = std::span<const End>;

  static Ends::iterator first_from(Index place, Ends::iterator begin, Ends::iterator end) {
    return std::lower_bound(begin, end, place, [](const End& e, Index at) { return e.to < at; });
  }
  static Ends above(Index place, const Ends& ends) {
    return {first_from(place + 1, ends.begin(), ends.end()), ends.end()};
  }

  /// Calls f(place, order in the one list, order in the other), ascending. Where one list is far
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

  VertexId vertex(Index place) const { return numbering_.ascending[place]; }
  Index number(Index place) const { return numbering_.number[vertex(place)]; }

  Index order_of(CircleCounter& counter, Index a, Index b, Index c, Index of_sides) const {
    const VertexId u = vertex(a), v = vertex(b), w = vertex(c);
    const int turn = orient(graph_.point(u), graph_.point(v), graph_.point(w));
    if (turn == 0) return kNone;
    return judge_(counter, turn > 0 ? Corners{u, v, w} : Corners{u, w, v}, of_sides);
  }

  const DelaunayGraph& graph_;
  const Index k_;
  const Numbering& numbering_;
  const Deadline deadline_;
  const EdgeLists lists_;
  const Judge judge_;
};

template <class Judge>
void for_each_triangle_of_sides(const DelaunayGraph& graph, std::span<const EdgeRecord> sides,
                                Index k, const Numbering& numbering, const Sink& sink,
                                const Deadline& deadline, const Judge& judge) {
  const TrianglesOfSides<Judge> triangles(graph, sides, k, numbering, deadline, judge);
  PerThread<CircleCounter> counters([&] { return CircleCounter(graph); });
  stream(graph.xy.size(), sink,
         [&](std::size_t first, std::size_t last, std::vector<TriangleRecord>& records) {
           CircleCounter& counter = counters.mine();
           for (std::size_t i = first; i < last; ++i) {
             const std::size_t vertices = numbering.beginning_at(i).size();
             const std::size_t before = records.size();
             for (std::size_t j = 0; j < vertices; ++j)
               triangles.add(counter, static_cast<Index>(i + j), records);
             if (vertices > 1)
               std::sort(records.begin() + std::ptrdiff_t(before), records.end(), is_less);
           }
         });
}

/// The number of points inside the circle; more than k also if one of them is in the triangle.
/// (Points on a side would be between the ends of a useful edge.)
Index order_if_empty(CircleCounter& counter, const DelaunayGraph& graph, const Corners& corners,
                     Index k) {
  const Index inside = counter.count(corners[0], corners[1], corners[2], k);
  if (inside > k) return inside;
  const Point &a = graph.point(corners[0]), &b = graph.point(corners[1]),
              &c = graph.point(corners[2]);
  for (const VertexId p : counter.inside()) {
    const Point& q = graph.point(p);
    if (orient(a, b, q) > 0 && orient(b, c, q) > 0 && orient(c, a, q) > 0) return k + 1;
  }
  return inside;
}

/// Three useful edges, and nothing in the triangle.
void for_each_valid_triangle(const DelaunayGraph& graph, Index k, const Numbering& numbering,
                             const Sink& sink, const Deadline& deadline) {
  const auto judge = [&](CircleCounter& counter, const Corners& corners, Index of_sides) {
    return std::max(order_if_empty(counter, graph, corners, k), of_sides);
  };
  for_each_triangle_of_sides(graph, all_edges(graph, EdgeClass::useful, k, deadline), k, numbering,
                             sink, deadline, judge);
}

void for_each_kod_triangle_among_walls(const DelaunayGraph& graph, Index k,
                                       const Numbering& numbering, const Sink& sink,
                                       const Deadline& deadline) {
  const auto judge = [&](CircleCounter& counter, const Corners& corners, Index) {
    return order_if_open(counter, graph, corners, k);
  };
  for_each_triangle_of_sides(graph, sides_of_open_triangles(graph, k, numbering, deadline), k,
                             numbering, sink, deadline, judge);
}

}  // namespace

void for_each_triangle(const DelaunayGraph& graph, TriangleClass triangle_class, Index k,
                       const Numbering& numbering, const Sink& sink, const Deadline& deadline) {
  if (triangle_class == TriangleClass::valid)
    for_each_valid_triangle(graph, k, numbering, sink, deadline);
  else if (graph.has_walls())
    for_each_kod_triangle_among_walls(graph, k, numbering, sink, deadline);
  else
    for_each_kod_triangle(graph, k, numbering, sink, deadline);
}

}  // namespace hodt
