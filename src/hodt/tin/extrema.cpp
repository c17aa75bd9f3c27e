#include "hodt/tin/extrema.h"

#include <cstdint>
#include <numeric>
#include <utility>

#include "hodt/base/buffer.h"

namespace hodt {

namespace {

/// What the triangles say about a vertex, in one word, so that each corner costs one access.
///
/// The upper bits tell inside from boundary: the sum, by exclusive or, of a code of the neighbours
/// in every triangle of the vertex. Around an inside vertex each neighbour occurs in two triangles
/// and cancels. At the end of edges with one triangle some do not. (Where several fans meet in one
/// vertex, four or more codes could cancel by chance, once in 2^60 such vertices.)
using State = std::uint64_t;
constexpr State kHasLower = 1;   ///< a neighbour is lower, ties broken by (x, y)
constexpr State kHasHigher = 2;  ///< a neighbour is higher, likewise
constexpr State kHasDeeper = 4;  ///< a neighbour has smaller z
constexpr State kInTriangle = 8;
constexpr State kMarks = 15;

/// One code a vertex, well mixed.
State code_of(Index vertex) {
  State x = (vertex + State{1}) * 0x9E3779B97F4A7C15;
  x = (x ^ (x >> 32)) * 0xBF58476D1CE4E5B9;
  return x & ~kMarks;
}

bool is_boundary(State state) {
  return (state & ~kMarks) != 0;
}

/// Sets of vertices of equal z that edges connect.
class LevelSets {
 public:
  explicit LevelSets(std::size_t vertices) : parents_(vertices) {
    std::iota(parents_.begin(), parents_.end(), Index{0});
  }
  Index find(Index v) {
    while (parents_[v] != v) v = parents_[v] = parents_[parents_[v]];
    return v;
  }
  void join(Index u, Index v) {
    u = find(u);
    v = find(v);
    if (u < v) std::swap(u, v);
    parents_[u] = v;
  }

 private:
  Buffer<Index> parents_;
};

class Counter {
 public:
  Counter(std::span<const Point> xy, std::span<const double> z, std::span<const Index> corners)
      : xy_(xy), z_(z), corners_(corners), states_(xy.size(), State{0}), levels_(xy.size()) {}

  ExtremaCount count() {
    for (std::size_t i = 0; i < corners_.size(); i += 3)
      mark_triangle(corners_[i], corners_[i + 1], corners_[i + 2]);
    ExtremaCount extrema;
    for (const State state : states_) {
      if (!(state & kInTriangle)) continue;
      if (!(state & kHasLower)) add(extrema.minima, is_boundary(state));
      if (!(state & kHasHigher)) add(extrema.maxima, is_boundary(state));
    }
    count_pits(extrema.pits);
    return extrema;
  }

 private:
  static void add(SplitCount& count, bool boundary) {
    ++(boundary ? count.boundary : count.interior);
  }

  void mark_triangle(Index a, Index b, Index c) {
    const double za = z_[a], zb = z_[b], zc = z_[c];
    const State x = code_of(a), y = code_of(b), z = code_of(c);
    if (za == zb || zb == zc || zc == za) {
      mark(a, (y ^ z) | kInTriangle);
      mark(b, (z ^ x) | kInTriangle);
      mark(c, (x ^ y) | kInTriangle);
      mark_edge(a, b);
      mark_edge(b, c);
      mark_edge(c, a);
      return;
    }
    // Without branches: which corner is higher is a matter of chance.
    mark(a, (y ^ z) | mark_below(za < zb) | mark_below(za < zc) | kInTriangle);
    mark(b, (z ^ x) | mark_below(zb < zc) | mark_below(zb < za) | kInTriangle);
    mark(c, (x ^ y) | mark_below(zc < za) | mark_below(zc < zb) | kInTriangle);
  }

  /// The code bits by exclusive or, the marks by or.
  void mark(Index v, State change) {
    states_[v] = ((states_[v] ^ change) & ~kMarks) | ((states_[v] | change) & kMarks);
  }

  /// The mark of an end of an edge that is not level: whether it lies below the other.
  static State mark_below(bool below) {
    return (kHasLower | kHasDeeper) ^ (-State{below} & (kHasLower | kHasDeeper | kHasHigher));
  }

  void mark_edge(Index u, Index v) {
    const double zu = z_[u], zv = z_[v];
    if (zu == zv) return mark_level_edge(u, v);
    mark(u, mark_below(zu < zv));
    mark(v, mark_below(zv < zu));
  }

  void mark_level_edge(Index u, Index v) {
    levels_.join(u, v);
    if (lexicographically_less(xy_[v], xy_[u])) std::swap(u, v);
    if (!lexicographically_less(xy_[u], xy_[v])) return;
    mark(u, kHasHigher);
    mark(v, kHasLower);
  }

  /// A level set is a pit if none of its vertices has a deeper neighbour.
  void count_pits(SplitCount& pits) {
    constexpr std::uint8_t deeper = 1, boundary = 2;
    Buffer<std::uint8_t> sets(states_.size(), std::uint8_t{0});
    for (Index v = 0; v < states_.size(); ++v) {
      const bool has_deeper = states_[v] & kHasDeeper;
      sets[levels_.find(v)] |= (has_deeper ? deeper : 0) | (is_boundary(states_[v]) ? boundary : 0);
    }
    for (Index v = 0; v < states_.size(); ++v) {
      const bool is_root = levels_.find(v) == v && (states_[v] & kInTriangle);
      if (is_root && !(sets[v] & deeper)) add(pits, sets[v] & boundary);
    }
  }

  std::span<const Point> xy_;
  std::span<const double> z_;
  std::span<const Index> corners_;
  Buffer<State> states_;
  LevelSets levels_;
};

}  // namespace

ExtremaCount count_extrema(std::span<const Point> xy, std::span<const double> z,
                           std::span<const Index> corners) {
  return Counter(xy, z, corners).count();
}

}  // namespace hodt
