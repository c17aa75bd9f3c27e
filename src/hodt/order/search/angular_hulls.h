// First points on either side of many edges at one vertex.
// Tested by tests/order/large_order_search_test.cpp.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hodt/base/deadline.h"
#include "hodt/base/ids.h"
#include "hodt/geometry/point.h"

namespace hodt {

/// The plane inverted at u turns circles through u into lines: a point is inside if its image is
/// beyond the line, seen from u. So the first point on one side of uv is where a line through the
/// image of v touches the hull of the images on that side. Images are not computed: every decision
/// is an in-circle test. Holds the hulls of runs of 1, 2, 4, … points in the order of their
/// directions; keeps its memory for the next set.
class AngularHulls {
 public:
  /// The points, in counter-clockwise order of their directions from u, all different. `images` are
  /// theirs, rounded; they only save tests. All must outlive it. Throws TimeIsUp if the deadline
  /// passes.
  void build(const Point& u, std::span<const Point> points, std::span<const Point> images,
             const Deadline& deadline = {});

  /// Of the points first, …, last - 1 (going on at the beginning after the last of all), the one
  /// whose circle with u and v holds no other of them. REQUIRES first < last, and that all are on
  /// the left of u -> v.
  Index first_on_left(Index v, Index first, Index last) const {
    return first_met<true>(v, first, last);
  }
  /// The same on the right.
  Index first_on_right(Index v, Index first, Index last) const {
    return first_met<false>(v, first, last);
  }

 private:
  struct Run {
    Index first, last;  // in chains_
    Box box;            // of the images
  };
  template <bool kLeft>
  Index first_met(Index v, Index first, Index last) const;

  Point u_;
  std::span<const Point> points_, images_;
  std::vector<std::vector<Run>> levels_;  // level i: of runs of 2^i points
  std::size_t used_ = 0;                  // levels
  std::vector<Index> chains_;  // hulls with u, but for u; empty if they do not fit into half a turn
};

/// The line through two images: p·normal = distance.
struct ImageLine {
  ImageLine(const Point& a, const Point& b);

  /// Whether the normal is known well, and leads away from the origin: closer to the origin than
  /// rounding, it might be the other way.
  bool is_sure() const { return distance > 2 * slack; }

  Point normal;     // a unit vector
  double distance;  // of the origin; 0 if the images are too close to each other to tell
  double slack;     // by how much the distance may be off
};

}  // namespace hodt
