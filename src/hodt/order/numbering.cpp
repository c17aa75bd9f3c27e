#include "hodt/order/numbering.h"

namespace hodt {

Numbering own_numbering(std::size_t vertices) {
  Numbering numbering{Buffer<Index>(vertices), Buffer<VertexId>(vertices)};
  for (Index v = 0; v < vertices; ++v) {
    numbering.number[v] = v;
    numbering.ascending[v] = VertexId(v);
  }
  return numbering;
}

Numbering row_numbering(const VertexSet& vertices, std::size_t rows) {
  Numbering numbering{Buffer<Index>(vertices.size()), Buffer<VertexId>(vertices.size())};
  Buffer<VertexId> of_row(rows, VertexId{});
  for (Index v = 0; v < vertices.size(); ++v) {
    numbering.number[v] = vertices.row[v];
    of_row[vertices.row[v]] = VertexId(v);
  }
  Index next = 0;
  for (const VertexId v : of_row)  // a duplicate's row has no vertex
    if (v.valid()) numbering.ascending[next++] = v;
  return numbering;
}

}  // namespace hodt
