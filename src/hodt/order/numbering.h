// The numbers by which lists of edges and triangles name their vertices.
// Tested by tests/order/edges_test.cpp.
#pragma once

#include <cstddef>
#include <span>

#include "hodt/base/buffer.h"
#include "hodt/base/ids.h"
#include "hodt/delaunay/spatial_order.h"

namespace hodt {

struct Numbering {
  /// Of every vertex. They differ, but for vertices of one row, where a domain touches itself.
  Buffer<Index> number;
  Buffer<VertexId> ascending;  ///< the vertices by their numbers

  /// The vertices of one number, if they begin at this place of the ascending ones; else none.
  std::span<const VertexId> beginning_at(std::size_t place) const {
    const auto number_at = [&](std::size_t at) { return number[ascending[at]]; };
    if (place > 0 && number_at(place - 1) == number_at(place)) return {};
    std::size_t end = place + 1;
    while (end < ascending.size() && number_at(end) == number_at(place)) ++end;
    return {ascending.data() + place, end - place};
  }
};

/// Each vertex by its own id: the fastest to go through, as neighbours are close.
Numbering own_numbering(std::size_t vertices);

/// Each vertex by its row of the input, of which there are `rows`.
Numbering row_numbering(const VertexSet& vertices, std::size_t rows);

}  // namespace hodt
