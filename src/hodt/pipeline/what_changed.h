// What an objective did to the Delaunay triangulation: local minima that went or stayed, and edges.
// Tested by tests/app/what_changed_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/delaunay/delaunay.h"
#include "hodt/hydrology/minima_to_keep.h"
#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

enum class Fate : std::uint8_t {
  removed,  ///< it has a lower neighbour now
  kept,     ///< it was to stay
  left,     ///< it is still one
  made      ///< it was none before
};

/// How deep a pit is and what it holds (see hydrology/pit_depths.h and pit_water.h).
struct PitSize {
  double depth = 0;
  double volume = 0;
};

/// A local minimum of one of the two triangulations.
struct MinimumChange {
  Index vertex = 0;  ///< of the TIN
  Fate fate = Fate::left;
  bool on_boundary = false;
  /// Whether it is lowest of what is as high and connected: what a hydrologist calls a pit. In the
  /// triangulation where it is one, the Delaunay triangulation if it is one there.
  bool is_pit = false;
  std::optional<PitSize> before, after;  ///< where it is a local minimum
  /// The lowest neighbour that a removed one has now, at the other end of a new edge; kNone for
  /// others.
  Index drains_to = kNone;
};

/// An edge that only one of the two triangulations has. Its ends are vertices of the TIN, u < v.
struct EdgeChange {
  Index u = 0, v = 0;
  bool is_new = false;
  Index order = 0;  ///< of a new one: the larger order of its two triangles; 0 for others
};

struct WhatChanged {
  std::vector<MinimumChange> minima;  ///< by vertex; empty without heights
  std::vector<EdgeChange> edges;      ///< by u and v
};

/// `before` and `after` have the same vertices, `orders` are those of the triangles of `after`.
/// `number` gives a vertex its number in the TIN; where a domain touches itself, several vertices
/// have the same, and are one point.
WhatChanged what_changed(const TriangleMesh& before, const TriangleMesh& after,
                         const VertexSet& vertices, const MinimaToKeep& keep,
                         std::span<const Index> orders, std::span<const Index> number);

}  // namespace hodt
