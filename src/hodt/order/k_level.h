// Lines with more than k points beyond them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/geometry/point.h"

namespace hodt {

/// The k-level of a set of points p: for every direction n (a unit vector) the value of p·n that
/// exactly k points exceed. Known as bounds per sector of directions, as narrow as it takes for few
/// points to be between the bounds. Answers are proofs, with all rounding bounded; not knowing is
/// the only other answer. Keeps its memory for the next set.
class KLevel {
 public:
  void build(std::span<const Point> points, Index k);

  /// Whether more than k points p have p·n > distance, surely and by far more than rounding.
  /// REQUIRES that n is of length 1 up to rounding, and distance > 0.
  bool surely_more(const Point& n, double distance) const;

  /// Whether more than k points are beyond every line through p that has the origin on its other
  /// side, surely.
  bool surely_deep(const Point& p) const;

  /// By how much p·n may be off, for all that is done here.
  double slack() const { return slack_; }

 private:
  /// The directions between two. Points of p·from and p·to above `high` are beyond the level in all
  /// of them; points of both below `low` in none.
  struct Sector {
    Point from, to;
    double low = 0, high = 0;
    Index beyond = 0;           // how many are in all
    Index first = 0, last = 0;  // the others, in undecided_; of a leaf
    Index children = 0;         // the first of two, if any
  };
  void split(Index sector, std::size_t first, std::size_t last);

  Index k_ = 0;
  double slack_ = 0;
  std::vector<Sector> sectors_;
  std::vector<Point> undecided_;
  std::vector<Point> stack_;  // of the lists of points that sectors being split leave undecided
  std::vector<double> values_;
};

}  // namespace hodt
