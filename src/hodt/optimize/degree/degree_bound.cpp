#include "hodt/optimize/degree/degree_bound.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "hodt/geometry/predicates.h"
#include "hodt/order/triangles.h"

namespace hodt {

namespace {

/// From one neighbour of a vertex to the next one, counter-clockwise, in a triangle.
struct Arc {
  VertexId from, to;
};

/// Counter-clockwise around v, beginning with the direction to the left. No two neighbours are in
/// the same one: an edge passes through no point.
class Around {
 public:
  Around(const DelaunayGraph& graph, VertexId v) : graph_(graph), center_(graph.point(v)) {}

  bool operator()(VertexId a, VertexId b) const {
    const bool is_a_below = is_below(a), is_b_below = is_below(b);
    if (is_a_below != is_b_below) return is_a_below;
    return orient(center_, graph_.point(a), graph_.point(b)) > 0;
  }

 private:
  /// In the half-plane of directions from the left, that included, to the right.
  bool is_below(VertexId w) const {
    const Point& p = graph_.point(w);
    return p.y < center_.y || (p.y == center_.y && p.x < center_.x);
  }

  const DelaunayGraph& graph_;
  const Point& center_;
};

/// The fewest arcs at an inner vertex that go around it once, or at one on the hull from its first
/// neighbour to its last.
class FewestAround {
 public:
  FewestAround(const DelaunayGraph& graph, VertexId v, std::span<const Arc> arcs) {
    const Around around(graph, v);
    for (const Arc& arc : arcs) neighbours_.push_back(arc.from), neighbours_.push_back(arc.to);
    std::sort(neighbours_.begin(), neighbours_.end(), around);
    neighbours_.erase(std::unique(neighbours_.begin(), neighbours_.end()), neighbours_.end());
    const auto place = [&](VertexId w) {
      return std::size_t(std::lower_bound(neighbours_.begin(), neighbours_.end(), w, around) -
                         neighbours_.begin());
    };
    onward_.resize(neighbours_.size());
    // Once around, one arc passes from the last places to the first ones.
    std::vector<std::size_t> starts;
    for (const Arc& arc : arcs) {
      const std::size_t from_place = place(arc.from), to_place = place(arc.to);
      onward_[from_place].push_back(to_place);
      if (to_place < from_place) starts.push_back(from_place);
    }
    std::sort(starts.begin(), starts.end());
    starts.erase(std::unique(starts.begin(), starts.end()), starts.end());
    const HalfEdgeId first = graph.outgoing[v];
    if (!graph.mesh.is_boundary(first)) {
      for (const std::size_t start : starts) fewest_ = std::min(fewest_, from(start, start));
      return;
    }
    HalfEdgeId last = first;
    for (HalfEdgeId h = first; h.valid(); h = graph.mesh.rotate_ccw(h)) last = h;
    fewest_ = 1 + from(place(graph.mesh.target(first)), place(graph.mesh.apex(last)));
  }

  /// The degree of the vertex that they come to.
  std::size_t degree() const { return fewest_; }

 private:
  std::size_t size() const { return neighbours_.size(); }

  /// The fewest arcs from start to end, which is once around if these are the same. Arcs that leap
  /// over the start are not of use: they belong to triangles that its edge crosses.
  std::size_t from(std::size_t start, std::size_t end) {
    const auto steps = [&](std::size_t i) { return (i + size() - start) % size(); };
    const std::size_t last = end == start ? size() : steps(end);
    fewest_to_.assign(size() + 1, size() + 1);
    fewest_to_[0] = 0;
    for (std::size_t i = 0; i < last; ++i)
      for (const std::size_t to : onward_[(start + i) % size()]) {
        const std::size_t j = to == start ? size() : steps(to);
        if (j > i) fewest_to_[j] = std::min(fewest_to_[j], fewest_to_[i] + 1);
      }
    return fewest_to_[last];
  }

  std::vector<VertexId> neighbours_;              // of all arcs, counter-clockwise
  std::vector<std::vector<std::size_t>> onward_;  // where the arcs from each lead
  std::vector<std::size_t> fewest_to_;
  std::size_t fewest_ = static_cast<std::size_t>(-1);
};

}  // namespace

Index degree_bound(const DelaunayGraph& graph, Index order, Index known, const Deadline& deadline) {
  // The Delaunay triangles go around as well: no vertex is of use whose degree is not above what
  // is known.
  const TriangleMesh& mesh = graph.mesh;
  std::vector<std::pair<Index, VertexId>> candidates;
  Buffer<Index> number(mesh.vertex_count(), kNone);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    Index degree = 0;
    graph.for_each_neighbour(VertexId(v), [&](VertexId) { ++degree; });
    if (degree <= known) continue;
    number[v] = static_cast<Index>(candidates.size());
    candidates.emplace_back(degree, VertexId(v));
  }
  if (candidates.empty()) return known;
  std::vector<std::vector<Arc>> arcs(candidates.size());
  const auto add = [&](VertexId v, VertexId from, VertexId to) {
    if (number[v] != kNone) arcs[number[v]].push_back({from, to});
  };
  const auto add_all = [&](std::span<const TriangleRecord> piece) {
    for (const TriangleRecord& t : piece) {
      VertexId a(t.a), b(t.b), c(t.c);
      if (orient(graph.point(a), graph.point(b), graph.point(c)) < 0) std::swap(b, c);
      add(a, b, c);
      add(b, c, a);
      add(c, a, b);
    }
  };
  for_each_triangle(graph, TriangleClass::valid, order, own_numbering(graph.xy.size()), add_all,
                    deadline);
  // The largest degrees first: what they leave possible is mostly more than others have.
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  for (const auto& [degree, v] : candidates)
    if (degree > known && !deadline.passed())
      known = std::max(known, Index(FewestAround(graph, v, arcs[number[v]]).degree()));
  return known;
}

}  // namespace hodt
