// How many useful edges there are of each order, how many Delaunay edges are fixed, and the order
// of a triangulation with many useful edges at once.
//
//   example_researcher points.csv
#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <vector>

#include "hodt/delaunay/delaunay.h"
#include "hodt/io/point_file.h"
#include "hodt/order/constrained/insert_edges.h"
#include "hodt/order/edges.h"

int main(int argc, char** argv) try {
  if (argc != 2) return 2;
  constexpr hodt::Index kMost = 8;
  const hodt::PointSet points = hodt::read_points(argv[1]);
  const hodt::Delaunay delaunay = hodt::delaunay(points);
  const hodt::DelaunayGraph graph(delaunay);
  const hodt::Numbering rows = hodt::row_numbering(delaunay.vertices, points.size());
  std::vector<std::size_t> of_order(kMost + 1, 0);
  hodt::for_each_edge(graph, hodt::EdgeClass::useful, kMost, rows, [&](auto edges) {
    for (const hodt::EdgeRecord& edge : edges) ++of_order[edge.order];
  });
  for (hodt::Index k = 0; k <= kMost; ++k) {
    std::size_t fixed = 0;
    hodt::for_each_edge(graph, hodt::EdgeClass::fixed, k, rows,
                        [&](auto edges) { fixed += edges.size(); });
    std::printf("order %u: %zu useful edges; %zu fixed for k = %u\n", k, of_order[k], fixed, k);
  }

  constexpr hodt::Index kInserted = 4;
  std::vector<std::array<hodt::VertexId, 2>> edges;
  hodt::for_each_edge(graph, hodt::EdgeClass::useful, kInserted,
                      hodt::own_numbering(graph.xy.size()), [&](auto found) {
                        for (const hodt::EdgeRecord& edge : found)
                          if (edge.order == kInserted)
                            edges.push_back({hodt::VertexId(edge.u), hodt::VertexId(edge.v)});
                      });
  const hodt::Insertion insertion = hodt::insert_edges(graph, edges);
  const auto inserted = std::count(insertion.inserted.begin(), insertion.inserted.end(), true);
  std::printf("useful edges of order %u that cross none before: %td, together of order %zu\n",
              kInserted, inserted, insertion.order_histogram.size() - 1);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
