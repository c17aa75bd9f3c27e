// Flips that improve a triangulation, as long as there are any.
// Tested by tests/optimize/optimize_measure_test.cpp.
#pragma once

#include "hodt/base/deadline.h"
#include "hodt/geometry/heights.h"
#include "hodt/optimize/measure/measures.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// Replaces the diagonal of a convex quadrilateral where that is better for the objective and both
/// new triangles have order at most k, until there is none left or the deadline passes. The mesh
/// must be a triangulation of the graph's points of order at most k, with the same half-edges on
/// the boundary. Each flip improves the sorted values of all triangles, so it ends.
void improve_by_flips(const DelaunayGraph& graph, const TriangleValues& values, Index k,
                      const Deadline& deadline, TriangleMesh& mesh);

/// The same for vertex degrees: the sorted degrees, the largest first, become lexicographically
/// smaller with each flip.
void reduce_degrees_by_flips(const DelaunayGraph& graph, Index k, const Deadline& deadline,
                             TriangleMesh& mesh);

/// The same for extrema: the flip heuristic of de Kok, van Kreveld and Löffler (2007). For local
/// minima a quadrilateral gets the diagonal at its lowest corner, which takes no lower neighbour
/// from anybody else, for maxima that at its highest; for both a flip has to leave fewer extrema.
/// `kept`: minima that stay, a flag for every vertex.
void remove_extrema_by_flips(const DelaunayGraph& graph, const Heights& heights,
                             Objective objective, const Buffer<bool>& kept, Index k,
                             const Deadline& deadline, TriangleMesh& mesh);

}  // namespace hodt
