// Counting points inside circles without looking at each: for circles that hold very many.
// Tested by tests/order/large_order_search_test.cpp.
#pragma once

#include <span>
#include <vector>

#include "hodt/base/buffer.h"
#include "hodt/base/ids.h"
#include "hodt/geometry/point.h"

namespace hodt {

/// A tree of boxes over points in spatial order: consecutive points are close, so a node is a run
/// of eight runs, and building it moves nothing. A circle costs the nodes whose boxes it crosses:
/// about √n of them in uniform points, whatever it holds.
class PointTree {
 public:
  explicit PointTree(std::span<const Point> points);

  /// The number of points inside the circle through a, b and c (counter-clockwise), or more than
  /// `limit` if there are more than `limit`.
  Index count(VertexId a, VertexId b, VertexId c, Index limit) const;
  /// Of the points to the left of the line from a to b, the one whose circle with a and b holds no
  /// other of them. REQUIRES that `start` is one of them; the closer it is, the better.
  VertexId first_on_left(VertexId a, VertexId b, VertexId start) const;
  /// The useful order of uv by Lemma 4, or more than `limit` if it is larger: the larger count of
  /// the two circles through u, v and the first point on either side. REQUIRES points of either
  /// side to start with, and none on the segment.
  Index useful_order(VertexId u, VertexId v, VertexId left, VertexId right, Index limit) const;

 private:
  static constexpr Index kWidth = 8;

  struct Leaf {
    double x[kWidth], y[kWidth];
  };
  struct Node {  // the boxes of its children
    double min_x[kWidth], min_y[kWidth], max_x[kWidth], max_y[kWidth];
  };
  struct Region;

  /// Calls whole(first, last) for runs of points that are surely in the region, and
  /// single(i, doubtful) for other points that are or may be in it, while these return true.
  template <class Whole, class Single>
  void visit(const Region& region, const Whole& whole, const Single& single) const;

  std::span<const Point> points_;
  Buffer<Leaf> leaves_;
  std::vector<Buffer<Node>> levels_;  // the first over the leaves, the last with one node
};

}  // namespace hodt
