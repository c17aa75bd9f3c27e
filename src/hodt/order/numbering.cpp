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
  // A duplicate's row has no vertex; a place where a domain touches itself has several.
  Buffer<Index> next(rows + 1, 0);
  for (Index v = 0; v < vertices.size(); ++v) {
    numbering.number[v] = vertices.row[v];
    ++next[vertices.row[v] + 1];
  }
  for (std::size_t row = 0; row < rows; ++row) next[row + 1] += next[row];
  for (Index v = 0; v < vertices.size(); ++v)
    numbering.ascending[next[vertices.row[v]]++] = VertexId(v);
  return numbering;
}

}  // namespace hodt
