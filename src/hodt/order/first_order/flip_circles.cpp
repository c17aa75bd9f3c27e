#include "hodt/order/first_order/flip_circles.h"

#include <algorithm>
#include <array>

#include "hodt/base/lanes.h"
#include "hodt/geometry/predicates.h"

namespace hodt {

namespace {

/// Edges side by side, with their apexes and the neighbours of both ends: of an end, these are all
/// that its circle has to be asked about (see CircleCounter).
class EdgeBlock {
 public:
  static constexpr std::size_t kSize = 60;  // no power of two: see nearest_beyond.cpp
  enum Verdict { kNo, kYes, kUnknown };

  void judge(const DelaunayGraph& graph, std::span<const HalfEdgeId> edges);
  Verdict verdict(std::size_t i) const {
    return is_impossible_[i] > 0 ? kNo : is_certain_[i] > 0 && is_complete_[i] ? kYes : kUnknown;
  }

 private:
  /// Beyond the other end and the apexes, so many neighbours of an end are asked about, some twice
  /// if there are fewer: a loop of a length that a processor can foresee.
  static constexpr int kNeighbours = 6;
  enum Place { kOrigin, kTarget, kLeft, kRight, kAtOrigin, kAtTarget = kAtOrigin + kNeighbours };
  static constexpr int kPlaces = kAtTarget + kNeighbours;

  /// A walk around one end of each edge, counter-clockwise from one apex to the other.
  struct Walk {
    std::array<HalfEdgeId, kSize> back;  // to the end, from the last neighbour met
    std::array<VertexId, kSize> last;    // the apex that ends it
  };

  void set(int place, std::size_t i, const Point& p) {
    x_[place][i] = p.x;
    y_[place][i] = p.y;
  }
  HODT_INLINE Point at(int place, std::size_t i) const { return {x_[place][i], y_[place][i]}; }
  void begin(const DelaunayGraph& graph, std::span<const HalfEdgeId> edges);
  template <bool kWalls>
  void walk_around_ends(const DelaunayGraph& graph, std::size_t size);
  template <bool kWalls>
  void step(const DelaunayGraph& graph, Walk& walk, int place, std::size_t size);
  void judge(std::size_t size);

  std::array<std::array<double, kSize>, kPlaces> x_, y_;
  Walk around_origin_, around_target_;
  std::array<bool, kSize> is_complete_;
  // Numbers like those that they come from, else the loop does not become vector code.
  std::array<double, kSize> is_certain_, is_impossible_;
};

void EdgeBlock::judge(const DelaunayGraph& graph, std::span<const HalfEdgeId> edges) {
  begin(graph, edges);
  if (graph.has_walls())
    walk_around_ends<true>(graph, edges.size());
  else
    walk_around_ends<false>(graph, edges.size());
  const auto is_at_end = [&](const Walk& walk, std::size_t i) {
    const HalfEdgeId onward = graph.mesh.twin(walk.back[i]);
    return onward.valid() && !graph.is_wall(onward) && graph.mesh.apex(onward) == walk.last[i];
  };
  for (std::size_t i = 0; i < edges.size(); ++i)
    is_complete_[i] = is_at_end(around_origin_, i) && is_at_end(around_target_, i);
  judge(edges.size());
}

template <bool kWalls>
void EdgeBlock::walk_around_ends(const DelaunayGraph& graph, std::size_t size) {
  for (int n = 0; n < kNeighbours; ++n) {
    step<kWalls>(graph, around_origin_, kAtOrigin + n, size);
    step<kWalls>(graph, around_target_, kAtTarget + n, size);
  }
}

void EdgeBlock::begin(const DelaunayGraph& graph, std::span<const HalfEdgeId> edges) {
  const TriangleMesh& mesh = graph.mesh;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const HalfEdgeId h = edges[i], twin = mesh.twin(h);
    const HalfEdgeId back = TriangleMesh::prev(h), twin_back = TriangleMesh::prev(twin);
    const VertexId left = mesh.origin(back), right = mesh.origin(twin_back);
    around_origin_.back[i] = back;
    around_origin_.last[i] = right;
    around_target_.back[i] = twin_back;
    around_target_.last[i] = left;
    set(kOrigin, i, graph.point(mesh.origin(h)));
    set(kTarget, i, graph.point(mesh.origin(twin)));
    set(kLeft, i, graph.point(left));
    set(kRight, i, graph.point(right));
  }
}

/// One step of each, unless its last apex would be met or the boundary or a wall is in the way:
/// side by side, as one step has to wait for the one before. How long they are is a matter of
/// chance: no branches.
template <bool kWalls>
void EdgeBlock::step(const DelaunayGraph& graph, Walk& walk, int place, std::size_t size) {
  const TriangleMesh& mesh = graph.mesh;
  for (std::size_t i = 0; i < size; ++i) {
    const HalfEdgeId back = walk.back[i], twin = mesh.twin(back);
    const bool is_open = twin.valid() && !(kWalls && graph.walls[back]);
    const HalfEdgeId onward = is_open ? TriangleMesh::prev(twin) : back;
    const Index is_end = -Index{mesh.origin(onward) == walk.last[i]};
    const HalfEdgeId now((back & is_end) | (onward & ~is_end));
    walk.back[i] = now;
    set(place, i, graph.point(mesh.origin(now)));
  }
}

void EdgeBlock::judge(std::size_t size) {
  run_in_lanes([&]<Index>() HODT_INLINE_LAMBDA {
    for (std::size_t i = 0; i < size; ++i) {
      exact::AllPositive all;
      const auto ask = [&](Place kept, Place left, Place right, Place lost,
                           int neighbours) HODT_INLINE_LAMBDA {
        all.add(exact::orient_rounded(at(left, i), at(right, i), at(kept, i)));
        const exact::CircleFilter circle(at(kept, i), at(left, i), at(right, i));
        const auto [value, bound] = circle(at(lost, i));
        all.add({-value, bound});
        for (int n = 0; n < kNeighbours; ++n) all.add(circle(at(neighbours + n, i)));
      };
      ask(kTarget, kLeft, kRight, kOrigin, kAtOrigin);
      ask(kOrigin, kRight, kLeft, kTarget, kAtTarget);
      is_certain_[i] = all.is_certain() ? 1 : 0;
      is_impossible_[i] = all.is_impossible() ? 1 : 0;
    }
  });
}

}  // namespace

void FlipCircles::hold_one_each(std::span<const HalfEdgeId> edges, bool* answers) {
  const TriangleMesh& mesh = graph_.mesh;
  EdgeBlock block;
  for (std::size_t begin = 0; begin < edges.size(); begin += EdgeBlock::kSize) {
    const auto part = edges.subspan(begin, std::min(EdgeBlock::kSize, edges.size() - begin));
    block.judge(graph_, part);
    for (std::size_t i = 0; i < part.size(); ++i) {
      const EdgeBlock::Verdict verdict = block.verdict(i);
      answers[begin + i] = verdict == EdgeBlock::kUnknown
                               ? holds_one(part[i]) && holds_one(mesh.twin(part[i]))
                               : verdict == EdgeBlock::kYes;
    }
  }
}

bool FlipCircles::holds_one(HalfEdgeId h) {
  const auto [a, b, c] = corners(graph_.mesh, h);
  return orient(graph_.point(a), graph_.point(b), graph_.point(c)) > 0 &&
         sole_.holds_origin_only({a, b, c}, h);
}

}  // namespace hodt
