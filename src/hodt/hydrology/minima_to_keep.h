// Which local minima are real, and stay.
// Tested by tests/app/keep_test.cpp.
#pragma once

#include <cstddef>
#include <span>

#include "hodt/base/buffer.h"
#include "hodt/geometry/places.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

struct MinimaToKeep {
  Buffer<bool> is_kept;  ///< of every vertex
  std::size_t count = 0;
  /// Polygons that no vertex is in.
  std::size_t empty_polygons = 0;
};

/// The local minima of the Delaunay triangulation that are at least `min_depth` deep (see
/// pit_depths.h; 0: none for its depth), that one of the polygons contains, or that the vertex
/// nearest to one of the points drains to. Throws InputError if the places cannot be on the map of
/// the vertices (see check_places.h), or if there are polygons and no vertex is in any.
MinimaToKeep minima_to_keep(const DelaunayGraph& graph, std::span<const double> z, double min_depth,
                            const Places& places);

}  // namespace hodt
