#include "hodt/optimize/flip/flips_across_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "hodt/base/parallel.h"
#include "hodt/geometry/predicates.h"
#include "hodt/order/circle_counter.h"

namespace hodt {

namespace {

using Gradient = EdgeValues::Gradient;

/// The vertices whose numbers agree but for so many of their last bits. They are near each other,
/// as the numbers go along a curve that fills the plane.
struct Block {
  unsigned bits = 0;
  Index number = 0;

  bool has(VertexId v) const { return std::uint64_t{v} >> bits == number; }
  Index begin() const { return static_cast<Index>(std::uint64_t{number} << bits); }
  Index end(std::size_t vertices) const {
    return static_cast<Index>(
        std::min<std::uint64_t>((std::uint64_t{number} + 1) << bits, vertices));
  }
};

/// The edges that a move changes, each before and after it, by their places in a list of values.
struct Change {
  std::array<std::uint8_t, 7> before, after;
  std::size_t size = 0;

  void add(Index b, Index a) {
    before[size] = static_cast<std::uint8_t>(b);
    after[size++] = static_cast<std::uint8_t>(a);
  }
};

/// Whether the values after a change are better: by the sum, or lexicographically by the sorted
/// values, the one that counts most first.
bool is_better(const Aggregator& aggregator, const Change& change, const double* values) {
  std::array<double, 7> before, after;
  for (std::size_t i = 0; i < change.size; ++i) {
    before[i] = values[change.before[i]];
    after[i] = values[change.after[i]];
  }
  const auto sum = [&](const std::array<double, 7>& v) {
    return std::accumulate(v.begin(), v.begin() + change.size, 0.0);
  };
  const Aggregate aggregate = aggregator.objective().aggregate;
  if (aggregate == Aggregate::sum) {
    const double old = sum(before), fresh = sum(after);
    // What rounding can have made of equal sums is no gain.
    return aggregator.better(fresh, old) && std::fabs(fresh - old) > 1e-13 * fresh + 1e-13 * old;
  }
  for (std::array<double, 7>* const v : {&before, &after}) {
    std::sort(v->begin(), v->begin() + change.size);
    if (aggregate == Aggregate::max) std::reverse(v->begin(), v->begin() + change.size);
  }
  for (std::size_t i = 0; i < change.size; ++i)
    if (before[i] != after[i]) return aggregator.better(after[i], before[i]);
  return false;
}

/// What all threads change, each in its own block: triangles with all corners there, their
/// gradients and their edges' twins. What a thread asks about beyond stays as it is meanwhile.
struct Shared {
  const DelaunayGraph& graph;
  const EdgeValues& values;
  const Index k;
  const Moves moves;
  const Deadline& deadline;
  TriangleMesh& mesh;
  Buffer<Gradient> gradients;  // of the triangles
  Buffer<bool> is_queued;      // a flag for every half-edge: written by the block of both its ends
};

/// Makes moves in a block until there are none left. Holds scratch memory for one thread.
class Mover {
 public:
  explicit Mover(Shared& shared)
      : s_(shared), mesh_(shared.mesh), counter_(shared.graph), many_(shared.values) {}

  /// Begins with these edges. Those that reach out of the block are `left` over.
  void run(const Block& block, std::span<const HalfEdgeId> edges, std::vector<HalfEdgeId>& left);

 private:
  /// A side of the quadrilateral around an edge ab, with triangles abc and bad. It runs from p to
  /// q, counter-clockwise, and is in the triangle pqr once ab is flipped.
  struct Side {
    HalfEdgeId h, flipped;  // what names it before and after that
    VertexId p, q, r;
    Index before, after;  // where its values are, if it is not on the boundary
  };
  struct Flip {
    HalfEdgeId h;
    VertexId a, b, c, d;
    Gradient with_a, with_b;    // of adc and bcd
    std::array<Side, 4> sides;  // bc and db, then ad and ca: triangle by triangle
    Index before, after;        // where the diagonals' values are
    Change change;
  };
  /// The flip of a side after that: of the quadrilateral of pqr and e beyond.
  struct SecondFlip {
    VertexId e;
    Gradient with_p, with_q;  // of per and qre
    Change change;            // by both flips
  };

  void push(HalfEdgeId h);
  void push_around(HalfEdgeId h);
  void empty_queue(Moves moves);
  void improve(HalfEdgeId h, Moves moves);
  bool find(HalfEdgeId h, Flip& flip);
  bool find(const Flip& flip, int side, SecondFlip& second);
  bool is_valid(const Flip& flip, int side, const SecondFlip& second);
  void improve_by_pairs(const Flip& flip);
  void make(HalfEdgeId h, const Gradient& with_origin, const Gradient& with_target);

  bool is_left(VertexId a, VertexId b, VertexId c) const {
    return orient(s_.graph.point(a), s_.graph.point(b), s_.graph.point(c)) > 0;
  }
  /// Whether ab can be replaced by dc where the triangles are abc and bad.
  bool can_flip(VertexId a, VertexId b, VertexId c, VertexId d) const {
    return is_left(a, d, c) && is_left(b, c, d) && !s_.graph.is_wall(a, b);
  }
  bool is_valid(VertexId a, VertexId b, VertexId c) {
    return counter_.count(a, b, c, s_.k) <= s_.k;
  }
  const Gradient& gradient(HalfEdgeId h) const { return s_.gradients[TriangleMesh::triangle(h)]; }
  /// Takes up an edge to be measured; returns where its value will be.
  Index add(VertexId a, VertexId b, const Gradient& left, const Gradient& right) {
    many_.set(size_, a, b, {left, left}, {right, right});
    return size_++;
  }
  /// The same of an edge that is there, once with the triangle on its left as it is and once with
  /// another one.
  void add_both(HalfEdgeId h, const Gradient& after, Change& change) {
    if (mesh_.is_boundary(h)) return;
    const VertexId from = mesh_.origin(h), to = mesh_.target(h);
    const Gradient& behind = gradient(mesh_.twin(h));
    const Index before = add(from, to, gradient(h), behind);
    change.add(before, add(from, to, after, behind));
  }

  Shared& s_;
  TriangleMesh& mesh_;
  CircleCounter counter_;
  ManyEdges many_;
  Index size_ = 0;  // of what it was given
  Block block_;
  std::vector<HalfEdgeId> queue_;
  std::vector<HalfEdgeId>* left_ = nullptr;
};

void Mover::push(HalfEdgeId h) {
  if (mesh_.is_boundary(h)) return;
  if (!block_.has(mesh_.origin(h)) || !block_.has(mesh_.target(h))) {
    left_->push_back(h);
    return;
  }
  if (s_.is_queued[h] || s_.is_queued[mesh_.twin(h)]) return;
  s_.is_queued[h] = true;
  queue_.push_back(h);
}

/// The edges of the triangle and of those beside it: what their flips change is not what it was.
void Mover::push_around(HalfEdgeId h) {
  for (const HalfEdgeId side : {h, TriangleMesh::next(h), TriangleMesh::prev(h)}) {
    push(side);
    if (mesh_.is_boundary(side)) continue;
    push(TriangleMesh::next(mesh_.twin(side)));
    push(TriangleMesh::prev(mesh_.twin(side)));
  }
}

void Mover::run(const Block& block, std::span<const HalfEdgeId> edges,
                std::vector<HalfEdgeId>& left) {
  block_ = block;
  left_ = &left;
  for (const HalfEdgeId h : edges) push(h);
  empty_queue(Moves::single);
  if (s_.moves == Moves::single) return;
  for (const HalfEdgeId h : edges) push(h);
  empty_queue(Moves::pairs);
}

void Mover::empty_queue(Moves moves) {
  constexpr int kOften = 64;
  for (int until_check = 0; !queue_.empty(); --until_check) {
    if (until_check == 0) {
      if (s_.deadline.passed()) break;
      until_check = kOften;
    }
    const HalfEdgeId h = queue_.back();
    queue_.pop_back();
    s_.is_queued[h] = false;
    improve(h, moves);
  }
  queue_.clear();
}

/// Makes a move that begins with a flip of h, if there is one.
void Mover::improve(HalfEdgeId h, Moves moves) {
  if (mesh_.is_boundary(h)) return;  // since it was queued, it came to name another edge
  Flip flip;
  if (!find(h, flip)) return;
  if (is_better(s_.values, flip.change, many_.measure(size_, 0, 0)) &&
      is_valid(flip.a, flip.d, flip.c) && is_valid(flip.b, flip.c, flip.d)) {
    const HalfEdgeId twin = mesh_.twin(h);
    make(h, flip.with_a, flip.with_b);
    push_around(h);
    push_around(twin);
  } else if (moves == Moves::pairs) {
    improve_by_pairs(flip);
  }
}

/// False if there is none, or none in this block alone.
bool Mover::find(HalfEdgeId h, Flip& flip) {
  const HalfEdgeId twin = mesh_.twin(h);
  const VertexId a = mesh_.origin(h), b = mesh_.target(h);
  const VertexId c = mesh_.apex(h), d = mesh_.apex(twin);
  if (!block_.has(a) || !block_.has(b) || !block_.has(c) || !block_.has(d)) {
    left_->push_back(h);
    return false;
  }
  if (!can_flip(a, b, c, d)) return false;
  flip.h = h;
  flip.a = a, flip.b = b, flip.c = c, flip.d = d;
  flip.with_a = s_.values.gradient(a, d, c);
  flip.with_b = s_.values.gradient(b, c, d);
  flip.sides = {{{TriangleMesh::next(h), twin, b, c, d, kNone, kNone},
                 {TriangleMesh::prev(twin), TriangleMesh::prev(twin), d, b, c, kNone, kNone},
                 {TriangleMesh::next(twin), h, a, d, c, kNone, kNone},
                 {TriangleMesh::prev(h), TriangleMesh::prev(h), c, a, d, kNone, kNone}}};
  size_ = 0;
  flip.before = add(a, b, gradient(h), gradient(twin));
  flip.after = add(d, c, flip.with_a, flip.with_b);
  flip.change.add(flip.before, flip.after);
  for (int i = 0; i < 4; ++i) {
    Side& side = flip.sides[i];
    if (mesh_.is_boundary(side.h)) continue;
    add_both(side.h, i < 2 ? flip.with_b : flip.with_a, flip.change);
    side.before = size_ - 2, side.after = size_ - 1;
  }
  return true;
}

/// The same of a flip of that side.
bool Mover::find(const Flip& flip, int side, SecondFlip& second) {
  const auto& [h, flipped, p, q, r, before, after] = flip.sides[side];
  if (mesh_.is_boundary(h)) return false;
  const HalfEdgeId beyond = mesh_.twin(h);
  const VertexId e = mesh_.apex(beyond);
  if (!block_.has(e)) {
    left_->push_back(flip.h);
    return false;
  }
  if (!can_flip(p, q, r, e)) return false;
  second.e = e;
  second.with_p = s_.values.gradient(p, e, r);
  second.with_q = s_.values.gradient(q, r, e);
  Change& change = second.change;
  change.add(before, add(e, r, second.with_p, second.with_q));
  // Behind qr and rp are the first flip's diagonal and the other side of its triangle, in turn.
  const bool is_diagonal_at_q = side % 2 == 0;
  const Gradient& across = side < 2 ? flip.with_a : flip.with_b;
  change.add(flip.before, is_diagonal_at_q ? add(q, r, second.with_q, across)
                                           : add(r, p, second.with_p, across));
  const Side& other = flip.sides[side ^ 1];
  if (!mesh_.is_boundary(other.h))
    change.add(other.before, add(other.p, other.q, is_diagonal_at_q ? second.with_p : second.with_q,
                                 gradient(mesh_.twin(other.h))));
  for (const int i : {side ^ 2, side ^ 3})
    if (!mesh_.is_boundary(flip.sides[i].h)) change.add(flip.sides[i].before, flip.sides[i].after);
  add_both(TriangleMesh::next(beyond), second.with_p, change);
  add_both(TriangleMesh::prev(beyond), second.with_q, change);
  return true;
}

bool Mover::is_valid(const Flip& flip, int side, const SecondFlip& second) {
  const auto& [h, flipped, p, q, r, before, after] = flip.sides[side];
  const bool is_rest_valid =
      side < 2 ? is_valid(flip.a, flip.d, flip.c) : is_valid(flip.b, flip.c, flip.d);
  return is_rest_valid && is_valid(p, second.e, r) && is_valid(q, r, second.e);
}

void Mover::improve_by_pairs(const Flip& flip) {
  std::array<SecondFlip, 4> seconds;
  std::array<bool, 4> is_found;
  for (int i = 0; i < 4; ++i) is_found[i] = find(flip, i, seconds[i]);
  const double* const values = many_.measure(size_, 0, 0);
  for (int i = 0; i < 4; ++i) {
    if (!is_found[i] || !is_better(s_.values, seconds[i].change, values) ||
        !is_valid(flip, i, seconds[i]))
      continue;
    const HalfEdgeId twin = mesh_.twin(flip.h), h = flip.sides[i].flipped;
    make(flip.h, flip.with_a, flip.with_b);
    const HalfEdgeId beyond = mesh_.twin(h);
    make(h, seconds[i].with_p, seconds[i].with_q);
    for (const HalfEdgeId changed : {i < 2 ? flip.h : twin, h, beyond}) push_around(changed);
    return;
  }
}

/// Flips h; the triangle of h is then the one with its origin.
void Mover::make(HalfEdgeId h, const Gradient& with_origin, const Gradient& with_target) {
  s_.gradients[TriangleMesh::triangle(h)] = with_origin;
  s_.gradients[TriangleMesh::triangle(mesh_.twin(h))] = with_target;
  mesh_.flip(h);
}

/// From one level of blocks to the next, larger one, edges that reached out of a block are within
/// one, or left over again. The last block is everything.
class Levels {
 public:
  explicit Levels(Shared& shared) : s_(shared), movers_([&shared] { return Mover(shared); }) {}

  void run() {
    begin();
    while (left_.size() > 1 && !s_.deadline.passed()) go_up();
  }

 private:
  static constexpr unsigned kFirst = 12, kStep = 3;
  using Edges = std::vector<HalfEdgeId>;

  std::size_t vertices() const { return s_.graph.xy.size(); }
  std::size_t count() const { return ((vertices() - 1) >> bits_) + 1; }

  /// With all edges, each in the block of its smaller end.
  void begin() {
    const Buffer<HalfEdgeId> outgoing = outgoing_halfedges(s_.mesh);
    left_.resize(count());
    parallel_for(0, left_.size(), 1, [&](std::size_t first, std::size_t last) {
      Edges edges;
      for (auto b = Index(first); b < last; ++b) {
        const Block block{bits_, b};
        edges.clear();
        for (Index v = block.begin(); v < block.end(vertices()); ++v)
          for_each_outgoing(s_.mesh, outgoing[v], [&](HalfEdgeId h) {
            if (s_.mesh.target(h) > v) edges.push_back(h);
          });
        movers_.mine().run(block, edges, left_[b]);
      }
    });
  }
  void go_up() {
    bits_ += kStep;
    std::vector<Edges> edges(count());
    for (std::size_t b = 0; b < left_.size(); ++b)
      edges[b >> kStep].insert(edges[b >> kStep].end(), left_[b].begin(), left_[b].end());
    left_.assign(edges.size(), {});
    parallel_for(0, edges.size(), 1, [&](std::size_t first, std::size_t last) {
      for (auto b = Index(first); b < last; ++b) movers_.mine().run({bits_, b}, edges[b], left_[b]);
    });
  }

  Shared& s_;
  PerThread<Mover> movers_;
  unsigned bits_ = kFirst;
  std::vector<Edges> left_;  // of each block
};

}  // namespace

void improve_across_edges(const DelaunayGraph& graph, const EdgeValues& values, Index k,
                          Moves moves, const Deadline& deadline, TriangleMesh& mesh) {
  Shared shared{graph,
                values,
                k,
                moves,
                deadline,
                mesh,
                values.gradients(mesh),
                Buffer<bool>(mesh.halfedge_count(), false)};
  Levels(shared).run();
}

}  // namespace hodt
