#include "hodt/order/crossings.h"

#include <algorithm>
#include <string>
#include <vector>

#include "../support/convert.h"
#include "families.h"
#include "oracle.h"
#include <gtest/gtest.h>

#include "hodt/order/edges.h"

namespace hodt {
namespace {

class Crossings : public testing::TestWithParam<families::Family> {};

/// All useful edges, Delaunay edges too, each against each by the oracle's exact arithmetic.
TEST_P(Crossings, are_those_of_every_pair) {
  for (const int n : {4, 9, 16}) {
    const PointSet points = support::to_point_set(GetParam().make(n, n));
    const Delaunay delaunay = hodt::delaunay(points);
    const DelaunayGraph graph(delaunay);
    const oracle::Instance instance(support::to_oracle(graph.xy));
    std::vector<PlainEdge> edges;
    for_each_edge(graph, EdgeClass::useful, 5, own_numbering(graph.xy.size()),
                  [&](std::span<const EdgeRecord> piece) {
                    for (const EdgeRecord& e : piece)
                      edges.push_back({VertexId(e.u), VertexId(e.v)});
                  });
    const CsrLists lists = crossings(graph, edges);
    ASSERT_EQ(lists.size(), edges.size());
    for (Index i = 0; i < edges.size(); ++i) {
      std::vector<Index> expected;
      for (Index j = 0; j < edges.size(); ++j)
        if (i != j && instance.segments_cross(int(edges[i].u), int(edges[i].v), int(edges[j].u),
                                              int(edges[j].v)))
          expected.push_back(j);
      ASSERT_EQ(std::vector<Index>(lists[i].begin(), lists[i].end()), expected);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Crossings, testing::ValuesIn(families::all()),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace hodt
