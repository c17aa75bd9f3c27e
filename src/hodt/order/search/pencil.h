// The circles through two points: what they hold tells the order of the edge between.
// Tested by tests/order/useful_edges_test.cpp.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "hodt/order/search/neighbourhood.h"
#include "hodt/order/search/passing.h"

namespace hodt {

/// Answers for the edges from the centre u of a neighbourhood to its other vertices. The circles
/// through u and v, from the one that is the half-plane on the right of u -> v to the one on the
/// left, take up the points on the left one by one and lose those on the right. REQUIRES, for an
/// answer up to `limit`, a neighbourhood gathered for that order or more. Holds scratch memory for
/// one thread; the neighbourhood must outlive it.
class Pencil {
 public:
  explicit Pencil(const Neighbourhood& around) : around_(around) {}

  /// The useful order of the edge to vertex i, by Lemma 4; limit + 1 if it is larger, or if the
  /// segment passes through a vertex.
  Index useful_order(Index i, Index limit);

  /// The order of that edge: the fewest points inside a circle through its ends; limit + 1 as
  /// above.
  Index edge_order(Index i, Index limit);

  /// A lower bound of that order, also of a neighbourhood not yet complete: the order among at most
  /// `sample` points on either side.
  Index least_order(Index i, std::size_t sample);

  /// Calls f(j, order) for every triangle of the centre, vertex i and vertex j that has at most
  /// `limit` points inside its circle.
  template <class F>
  void for_each_triangle(Index i, Index limit, const F& f) {
    put_in_order(i);
    Index inside = between_count_ + right_count_;
    for (const Passed& passed : passed_) {
      if (!passed.on_left) --inside;
      if (inside <= limit) f(passed.vertex, inside);
      if (passed.on_left) ++inside;
    }
  }

 private:
  enum class Side { left, right };
  /// What an attempt in floating point can end with, beside an order.
  static constexpr Index kNoEdge = kNone;
  static constexpr Index kUnclear = kNone - 1;

  /// A point where it enters or leaves the circles.
  struct Passed {
    Passing at;
    Index vertex;
    bool on_left;
  };

  Index count_beyond(Index i, Index first, Side side, Index limit);
  Index useful_order_exactly(Index i, Index limit) const;
  void put_in_order(Index i, std::size_t sample = std::numeric_limits<std::size_t>::max());
  Index fewest_inside() const;
  bool is_passed_before(Index i, const Passed& p, const Passed& q) const;
  int side_of(Index i, Index p) const;
  bool is_between(Index i, Index p) const;
  bool is_inside(Index i, Index first, Side side, Index p) const;

  const Neighbourhood& around_;
  std::vector<LocalPoints::Split> split_;
  // Of the edge asked about last: who enters and leaves the circles, in this order, who is inside
  // at the beginning, and who all the time.
  std::vector<Passed> passed_;
  Index right_count_ = 0, between_count_ = 0;
};

}  // namespace hodt
