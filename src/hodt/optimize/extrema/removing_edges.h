// Which edges to choose so that the fewest targets stay extrema.
// Tested by tests/optimize/remove_extrema_test.cpp.
#pragma once

#include <cstddef>
#include <vector>

#include "hodt/optimize/extrema/extrema_targets.h"
#include "hodt/optimize/solve/edge_selection.h"
#include "hodt/order/crossings.h"

namespace hodt {

/// Edges that remove targets, no two of which cross.
struct RemovingEdges {
  std::vector<PlainEdge> chosen;  ///< Delaunay edges are left out: what does not cross them is here
  /// Of the targets that have edges some stay extrema in every triangulation of the order, so many
  /// at least.
  std::size_t bound = 0;
  /// The targets that keep each other from being removed.
  std::vector<Index> contested;
  /// How many pairs of edges crossed.
  std::size_t crossings = 0;
};

/// The edges that remove as many targets as edges can that do not cross: at least as many as any
/// triangulation of the order removes, if all edges of the contested targets are known. Throws
/// TimeIsUp if the deadline passes before there is any choice.
RemovingEdges select_removing_edges(const DelaunayGraph& graph, const ExtremaTargets& targets,
                                    const Deadline& deadline, std::size_t most_work);

}  // namespace hodt
