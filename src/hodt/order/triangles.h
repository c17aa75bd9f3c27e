// All triangles of a class, with their orders, as a stream.
#pragma once

#include <functional>
#include <span>

#include "hodt/base/deadline.h"
#include "hodt/order/delaunay_graph.h"
#include "hodt/order/numbering.h"

namespace hodt {

enum class TriangleClass {
  /// Any three points, not on a line, with at most k points inside their circle; other points may
  /// lie in the triangle or on its sides. By the number inside. With walls: that no wall enters,
  /// and
  /// what is reached from the triangle counts.
  kod,
  /// Of these, the ones with no point in them nor on their boundary and three useful edges: those
  /// that a triangulation of order k can contain. By the larger of the number inside and the edges'
  /// useful orders.
  valid,
};

/// A triangle by the numbers of its corners, a < b < c.
struct TriangleRecord {
  Index a, b, c;
  Index order;
  friend bool operator==(const TriangleRecord&, const TriangleRecord&) = default;
};

/// Passes all triangles of the class and of order at most k to the sink, in pieces, sorted by a, b
/// and c; a piece can be empty. Memory does not grow with their number (but for `valid`: all useful
/// edges; and with walls all k-OD edges). The same pieces on any number of threads. Throws TimeIsUp
/// if the deadline passes.
void for_each_triangle(const DelaunayGraph& graph, TriangleClass triangle_class, Index k,
                       const Numbering& numbering,
                       const std::function<void(std::span<const TriangleRecord>)>& sink,
                       const Deadline& deadline = {});

}  // namespace hodt
