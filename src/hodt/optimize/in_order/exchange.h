// Triangles of a mesh exchanged for others.
// Tested by tests/optimize/in_order_test.cpp.
#pragma once

#include <array>
#include <vector>

#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

/// Some triangles, others that cover the same region, and the edges that this concerns.
struct Exchange {
  using Corners = std::array<VertexId, 3>;
  /// The edge ab between the triangles abc, on its left, and bad.
  struct Edge {
    VertexId a, b, c, d;
  };
  struct Side {
    std::vector<Corners> triangles;
    std::vector<Edge> inside;  ///< between two of the triangles
    std::vector<Edge>
        around;  ///< between one of them and one beyond: the same edges before and after

    void clear() {
      triangles.clear();
      inside.clear();
      around.clear();
    }
  };
  Side before, after;
};

}  // namespace hodt
