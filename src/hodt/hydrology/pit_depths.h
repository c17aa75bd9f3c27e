// How deep the pits of a triangulated terrain are.
#pragma once

#include <span>
#include <vector>

#include "hodt/geometry/point.h"
#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

struct Pit {
  VertexId bottom;  ///< a local minimum
  double depth;     ///< from there to where water would flow over: 0 on the boundary
  double level;     ///< the height where it would
};

/// All local minima with their depths, in the order of vertices. Filled with water, a pit flows
/// over at the lowest vertex of its rim, into a lower one or one that has flowed over, or out over
/// the boundary. Vertices of no triangle are no pits. By flooding from the lowest vertex up:
/// O(n log n).
std::vector<Pit> pit_depths(const TriangleMesh& mesh, std::span<const Point> xy,
                            std::span<const double> z);

/// The local minimum that water from the vertex flows to, always on to the lowest neighbour.
VertexId drains_to(const TriangleMesh& mesh, std::span<const HalfEdgeId> outgoing,
                   std::span<const Point> xy, std::span<const double> z, VertexId from);

}  // namespace hodt
