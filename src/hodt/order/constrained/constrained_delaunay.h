// The constrained Delaunay triangulation: given edges are there, and the rest is as Delaunay as
// they let it be.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "hodt/delaunay/delaunay.h"

namespace hodt {

/// Two of the edges that were to be inserted have a point in common that is inside both: their
/// numbers, the smaller first.
struct CrossingEdges {
  Index first, second;
  friend auto operator<=>(const CrossingEdges&, const CrossingEdges&) = default;
};

/// Inserts edges into a Delaunay triangulation as walls. A vertex that lies on an edge splits it;
/// edges may overlap, be given twice, or have equal ends, which is no edge. No triangle of the
/// result has a vertex inside its circle that can be reached from it without crossing a wall. That
/// is one triangulation, under the rule for ties: it does not depend on the order of the edges.
/// Takes the time of a walk along each edge, and m log m steps for one that crosses m edges where
/// splits are as even as in quicksort.
///
/// Returns the pairs of edges that cross, sorted, none twice. If there are any, the later edge of a
/// pair is not inserted between the vertices around the crossing, and pairs of two such edges may
/// be missing. REQUIRES delaunay.walls to be empty. The same bytes on any number of threads.
std::vector<CrossingEdges> insert_walls(Delaunay& delaunay,
                                        std::span<const std::array<VertexId, 2>> edges);

}  // namespace hodt
