// Lines with more than k points beyond them.
// Tested by tests/order/large_order_search_test.cpp.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hodt/base/deadline.h"
#include "hodt/base/ids.h"
#include "hodt/geometry/point.h"

namespace hodt {

/// The k-level of a set of points p: for every direction n (a unit vector) the value of p·n that
/// exactly k points exceed. Known as bounds per sector of directions, as narrow as it takes for few
/// points to be between the bounds. Answers are proofs, with all rounding bounded; not knowing is
/// the only other answer. Keeps its memory for the next set.
class KLevel {
 public:
  /// Throws TimeIsUp if the deadline passes.
  void build(std::span<const Point> points, Index k, const Deadline& deadline = {});

  /// p·n is off by less than so much of |p|, for the points p and for n of length 1, both rounded.
  static constexpr double kRounding = 1e-9;

  /// Whether more than k points p have p·n > distance, surely and by more than rounding. REQUIRES
  /// that n is of length 1 up to rounding, and distance > 0.
  bool surely_more(const Point& n, double distance) const;

  /// Whether more than k points are beyond every line through p that has the origin on its other
  /// side, surely.
  bool surely_deep(const Point& p) const;

 private:
  /// The directions between two. Points of p·from and p·to above `high` are beyond the level in all
  /// of them; points of both below `low` in none.
  struct Sector {
    Point from, to;
    Index first, last;   // in undecided_: those that were around, and then the others
    Index beyond = 0;    // how many are in all
    Index children = 0;  // the first of two, if any
    double low = 0, high = 0;
  };
  void bound(Sector& sector);
  bool is_worth_splitting(const Sector& sector) const;

  Index k_ = 0;
  std::size_t most_stored_ = 0;
  std::vector<Sector> sectors_;
  std::vector<Point> undecided_;
  std::vector<double> values_;
};

}  // namespace hodt
