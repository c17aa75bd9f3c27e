// The part of a constrained Delaunay triangulation that is wanted.
// Tested by tests/order/constrained_order_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "hodt/delaunay/delaunay.h"

namespace hodt {

/// How many triangles were taken away, and how many vertices, as no triangle had them any more.
struct Restriction {
  std::size_t outside = 0, too_long = 0, unused = 0;
};

/// Takes away the triangles outside of the edges that bound the domain, which have to be walls, by
/// the even-odd rule; then, from outside in, those with an edge at the boundary that is no wall and
/// longer than max_edge. What is left is numbered anew, in the same order. Where the domain touches
/// itself at a vertex, each side gets a vertex of its own, with the same row.
///
/// Throws InputError if an edge of the boundary ends where no other one begins, naming the row, or
/// if no triangle is left.
Restriction restrict_to_domain(Delaunay& delaunay,
                               std::span<const std::array<VertexId, 2>> boundary, double max_edge);

}  // namespace hodt
