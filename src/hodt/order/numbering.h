// The numbers by which lists of edges and triangles name their vertices.
// Tested by tests/order/edges_test.cpp.
#pragma once

#include "hodt/base/buffer.h"
#include "hodt/base/ids.h"
#include "hodt/delaunay/spatial_order.h"

namespace hodt {

struct Numbering {
  Buffer<Index> number;        ///< of every vertex, all different
  Buffer<VertexId> ascending;  ///< the vertices by their numbers
};

/// Each vertex by its own id: the fastest to go through, as neighbours are close.
Numbering own_numbering(std::size_t vertices);

/// Each vertex by its row of the input, of which there are `rows`.
Numbering row_numbering(const VertexSet& vertices, std::size_t rows);

}  // namespace hodt
