#include "hodt/optimize/flip/flips_across_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
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

/// What a change gains of a sum, and how large the numbers are that this is the difference of.
struct Gain {
  double gain = 0, scale = 0;

  Gain plus(const Gain& other) const { return {gain + other.gain, scale + other.scale}; }
  /// What rounding can have made of equal sums is none.
  bool is_real() const { return gain > kRoundingOfSums * scale; }
};

Gain gain_of_sum(const Aggregator& aggregator, const Change& change, const double* values) {
  double before = 0, after = 0;
  for (std::size_t i = 0; i < change.size; ++i) {
    before += values[change.before[i]];
    after += values[change.after[i]];
  }
  return {aggregator.sign() * (before - after), before + after};
}

/// Whether it makes largest or smallest values better.
bool is_better_sorted(const Aggregator& aggregator, const Change& change, const double* values) {
  std::array<double, 7> before, after;
  for (std::size_t i = 0; i < change.size; ++i) {
    before[i] = values[change.before[i]];
    after[i] = values[change.after[i]];
  }
  return is_better_sorted(aggregator, std::span(before).first(change.size),
                          std::span(after).first(change.size));
}

/// What all threads change, each in its own block: triangles with all corners there, their
/// gradients and their edges' twins. What a thread asks about beyond stays as it is meanwhile.
struct Shared {
  const DelaunayGraph& graph;
  const EdgeValues& values;
  const Index k;
  const int most_flips;
  const Deadline& deadline;
  TriangleMesh& mesh;
  Buffer<Gradient> gradients;  // of the triangles
  Buffer<bool> is_queued;      // a flag for every half-edge: written by the block of both its ends
  MoveGuard* guard;            // or nullptr
};

/// Makes moves in a block until there are none left. Holds scratch memory for one thread.
class Mover {
 public:
  explicit Mover(Shared& shared)
      : s_(shared), mesh_(shared.mesh), counter_(shared.graph), many_(shared.values) {}

  /// Begins with these edges. Those that reach out of the block are `left` over.
  void run(const Block& block, std::span<const HalfEdgeId> edges, std::vector<HalfEdgeId>& left);

 private:
  static constexpr int kUsual = 3;
  /// Of all that a move changes, before and after together, what a part of it may lose.
  static constexpr double kMostLoss = 0.2;
  /// Of a sum: more than moves of three flips gain over single ones on most terrain.
  static constexpr double kMuch = 0.05;

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

  /// A flip that was made, and what its triangles' gradients were.
  struct Made {
    HalfEdgeId h;
    std::array<TriangleId, 2> triangles;
    std::array<Gradient, 2> gradients;
  };

  void push(HalfEdgeId h);
  void push_around(HalfEdgeId h);
  double improve_all(std::span<const HalfEdgeId> edges, int most, double most_loss);
  double value_of(std::span<const HalfEdgeId> edges) const;
  bool is_time_up();
  bool improve(HalfEdgeId h, int most);
  bool go_on(const Flip& flip, const Gain& so_far, int most);
  bool find(HalfEdgeId h, Flip& flip);
  bool find(const Flip& flip, int side, SecondFlip& second);
  bool is_better(const Change& change, const Gain& so_far, const double* values) const;
  void make(HalfEdgeId h, const Gradient& with_origin, const Gradient& with_target);
  void undo();
  bool keep_if_valid(const Gain& gain);
  bool are_valid();

  /// Whether it does not make a sum much worse.
  bool is_beginning(const Gain& gain) const {
    return !s_.values.is_sum() || -gain.gain <= most_loss_ * gain.scale;
  }
  bool is_left(VertexId a, VertexId b, VertexId c) const {
    return orient(s_.graph.point(a), s_.graph.point(b), s_.graph.point(c)) > 0;
  }
  /// Whether ab can be replaced by dc where the triangles are abc and bad.
  bool can_flip(VertexId a, VertexId b, VertexId c, VertexId d) const {
    return is_left(a, d, c) && is_left(b, c, d) && !s_.graph.is_wall(a, b);
  }
  const Gradient& gradient(HalfEdgeId h) const { return s_.gradients[TriangleMesh::triangle(h)]; }
  /// Takes up an edge to be measured; returns where its value will be.
  Index add(VertexId a, VertexId b, const Gradient& left, const Gradient& right) {
    many_.set(size_, a, b, left, right);
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
  std::vector<HalfEdgeId> queue_, turn_;
  std::vector<HalfEdgeId>* left_ = nullptr;
  std::vector<Made> made_;  // of the move that is tried
  std::vector<Quadrilateral> flips_;
  bool reaches_out_ = false;  // a move would leave the block
  double most_loss_ = 0, gained_ = 0;
  int until_check_ = 0;
  bool is_time_up_ = false;
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
  // Longer moves take longer to look for: once there are few left, and where they gain much.
  improve_all(edges, 1, kMostLoss);
  if (s_.most_flips == 1) return;
  const double gained = improve_all(edges, std::min(s_.most_flips, kUsual), kMostLoss);
  if (s_.most_flips > kUsual && s_.values.is_sum() && gained > kMuch * value_of(edges))
    improve_all(edges, s_.most_flips, 1);
}

double Mover::value_of(std::span<const HalfEdgeId> edges) const {
  double value = 0;
  for (const HalfEdgeId h : edges)
    if (!mesh_.is_boundary(h))
      value +=
          s_.values.across(mesh_.origin(h), mesh_.target(h), gradient(h), gradient(mesh_.twin(h)));
  return value;
}

/// By moves of so many flips at most; returns what they gain.
double Mover::improve_all(std::span<const HalfEdgeId> edges, int most, double most_loss) {
  most_loss_ = most_loss;
  gained_ = 0;
  for (const HalfEdgeId h : edges) push(h);
  // First come, first served: what is near a move waits until the rest had its turn.
  while (!queue_.empty()) {
    turn_.swap(queue_);
    queue_.clear();
    for (const HalfEdgeId h : turn_) {
      s_.is_queued[h] = false;
      if (is_time_up()) continue;
      reaches_out_ = false;
      if (!improve(h, most) && reaches_out_) left_->push_back(h);
    }
  }
  return gained_;
}

bool Mover::is_time_up() {
  constexpr int kOften = 64;
  if (until_check_-- == 0) {
    until_check_ = kOften;
    is_time_up_ = s_.deadline.passed();
  }
  return is_time_up_;
}

/// Makes a move that begins with a flip of h, if there is one.
bool Mover::improve(HalfEdgeId h, int most) {
  if (mesh_.is_boundary(h)) return false;  // since it was queued, it came to name another edge
  Flip flip;
  if (!find(h, flip)) return false;
  const double* const values = many_.measure(size_, 0, 0);
  const Gain gain = gain_of_sum(s_.values, flip.change, values);
  if (is_better(flip.change, {}, values)) {
    make(h, flip.with_a, flip.with_b);
    if (keep_if_valid(gain)) return true;
  }
  return most > 1 && is_beginning(gain) && go_on(flip, {}, most);
}

/// Of both flips, or of a sum, of all.
bool Mover::is_better(const Change& change, const Gain& so_far, const double* values) const {
  return s_.values.is_sum() ? gain_of_sum(s_.values, change, values).plus(so_far).is_real()
                            : is_better_sorted(s_.values, change, values);
}

/// False if there is none, or none in this block alone.
bool Mover::find(HalfEdgeId h, Flip& flip) {
  const HalfEdgeId twin = mesh_.twin(h);
  const VertexId a = mesh_.origin(h), b = mesh_.target(h);
  const VertexId c = mesh_.apex(h), d = mesh_.apex(twin);
  if (!block_.has(a) || !block_.has(b) || !block_.has(c) || !block_.has(d)) {
    reaches_out_ = true;
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
    reaches_out_ = true;
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

/// By this flip and then, after what was gained so far, another one of a side; or, of sums, by
/// more.
bool Mover::go_on(const Flip& flip, const Gain& so_far, int most) {
  std::array<SecondFlip, 4> seconds;
  std::array<bool, 4> is_found;
  for (int i = 0; i < 4; ++i) is_found[i] = find(flip, i, seconds[i]);
  const double* const values = many_.measure(size_, 0, 0);
  for (int i = 0; i < 4; ++i) {
    if (!is_found[i] || !is_better(seconds[i].change, so_far, values)) continue;
    make(flip.h, flip.with_a, flip.with_b);
    make(flip.sides[i].flipped, seconds[i].with_p, seconds[i].with_q);
    if (keep_if_valid(gain_of_sum(s_.values, seconds[i].change, values).plus(so_far))) return true;
    undo();
  }
  const Gain gain = gain_of_sum(s_.values, flip.change, values).plus(so_far);
  if (most < 3 || !s_.values.is_sum() || !is_beginning(gain)) return false;
  std::array<bool, 4> is_promising;
  for (int i = 0; i < 4; ++i)
    is_promising[i] =
        is_found[i] && is_beginning(gain_of_sum(s_.values, seconds[i].change, values).plus(so_far));
  make(flip.h, flip.with_a, flip.with_b);
  for (int i = 0; i < 4; ++i) {
    Flip second;
    if (is_promising[i] && find(flip.sides[i].flipped, second) && go_on(second, gain, most - 1))
      return true;
  }
  undo();
  return false;
}

/// Flips h; the triangle of h is then the one with its origin.
void Mover::make(HalfEdgeId h, const Gradient& with_origin, const Gradient& with_target) {
  const TriangleId t = TriangleMesh::triangle(h), u = TriangleMesh::triangle(mesh_.twin(h));
  made_.push_back({h, {t, u}, {s_.gradients[t], s_.gradients[u]}});
  flips_.push_back({mesh_.origin(h), mesh_.target(h), mesh_.apex(h), mesh_.apex(mesh_.twin(h))});
  s_.gradients[t] = with_origin;
  s_.gradients[u] = with_target;
  mesh_.flip(h);
}

/// Takes the last flip back, with all the names that there were.
void Mover::undo() {
  const auto& [h, triangles, gradients] = made_.back();
  const HalfEdgeId after = TriangleMesh::next(h), across = mesh_.twin(after);
  const HalfEdgeId twin = TriangleMesh::prev(across);
  const VertexId a = mesh_.origin(h), b = mesh_.origin(twin);
  const HalfEdgeId outside_ad = mesh_.twin(h), outside_bc = mesh_.twin(twin);
  mesh_.set_origin(after, b);
  mesh_.set_origin(across, a);
  mesh_.glue(h, twin);
  mesh_.glue(after, outside_bc);
  mesh_.glue(across, outside_ad);
  for (int i = 0; i < 2; ++i) s_.gradients[triangles[i]] = gradients[i];
  made_.pop_back();
  flips_.pop_back();
}

/// Ends the move that was made; else takes its last flip back.
bool Mover::keep_if_valid(const Gain& gain) {
  if ((s_.guard && !s_.guard->allows(flips_)) || !are_valid()) {
    undo();
    return false;
  }
  for (const Made& made : made_)
    for (const TriangleId t : made.triangles) push_around(TriangleMesh::halfedge(t));
  if (s_.guard) s_.guard->take(flips_);
  made_.clear();
  flips_.clear();
  gained_ += gain.gain;
  return true;
}

bool Mover::are_valid() {
  for (std::size_t i = made_.size(); i-- > 0;)
    for (const TriangleId t : made_[i].triangles) {
      const auto is_counted = [&](const Made& made) {
        return made.triangles[0] == t || made.triangles[1] == t;
      };
      if (std::any_of(made_.begin() + std::ptrdiff_t(i + 1), made_.end(), is_counted)) continue;
      const auto [a, b, c] = mesh_.corners(t);
      if (counter_.count(a, b, c, s_.k) > s_.k) return false;
    }
  return true;
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
                          int most_flips, const Deadline& deadline, TriangleMesh& mesh,
                          MoveGuard* guard) {
  Shared shared{graph,
                values,
                k,
                most_flips,
                deadline,
                mesh,
                values.gradients(mesh),
                Buffer<bool>(mesh.halfedge_count(), false),
                guard};
  Levels(shared).run();
}

}  // namespace hodt
