#include "hodt/optimize/degree/minimize_degree.h"

#include <algorithm>
#include <array>
#include <vector>

#include "hodt/mesh/degrees.h"
#include "hodt/optimize/degree/degree_bound.h"
#include "hodt/optimize/flip/flips.h"
#include "hodt/optimize/solve/diagonal_selection.h"
#include "hodt/order/first_order/first_order.h"
#include "hodt/order/fixed_edges.h"

namespace hodt {

namespace {

/// Up to it, flips are tried at every order.
constexpr Index kStepwise = 16;
/// Beyond it there are too many triangles to look at, and hardly a vertex needs more than the
/// average.
constexpr Index kMostForBound = 64;

Index largest(const Buffer<Index>& degrees) {
  return *std::max_element(degrees.begin(), degrees.end());
}

/// Somebody has at least the average.
Index average_degree(const TriangleMesh& mesh) {
  // Each half-edge has one end of its own; on the boundary it has the other one, too.
  const auto boundary = std::count(mesh.twins().begin(), mesh.twins().end(), kNone);
  const std::size_t ends = mesh.halfedge_count() + static_cast<std::size_t>(boundary);
  return static_cast<Index>((ends + mesh.vertex_count() - 1) / mesh.vertex_count());
}

/// Finds the flips to the best triangulation of order 1; returns a proven lower bound.
Index choose_diagonals(const DelaunayGraph& graph, const Deadline& deadline,
                       std::vector<HalfEdgeId>& flips) {
  const TriangleMesh& mesh = graph.mesh;
  const std::vector<HalfEdgeId> diagonals = first_order_edges(graph);
  Buffer<Index> base = degrees_of(mesh);
  const Index delaunay = largest(base);
  std::vector<DiagonalSelection::Corners> corners;
  for (const HalfEdgeId h : diagonals) {
    const VertexId a = mesh.origin(h), b = mesh.target(h);
    --base[a];
    --base[b];
    corners.push_back({a, b, mesh.apex(h), mesh.apex(mesh.twin(h))});
  }
  // Below what a vertex has without any of the diagonals nothing is possible.
  Index bound = std::max(average_degree(mesh), largest(base));
  const DiagonalSelection selection(std::move(base), std::move(corners));
  std::vector<bool> chosen(diagonals.size(), false);
  const auto can_keep_below = [&](Index most) {
    std::vector<bool> found(diagonals.size(), false);
    const DiagonalSelection::Answer answer = selection.keep_below(most, found, deadline);
    if (answer == DiagonalSelection::Answer::possible) chosen = std::move(found);
    if (answer == DiagonalSelection::Answer::impossible) bound = most + 1;  // nor is less
    return answer == DiagonalSelection::Answer::possible;
  };
  // One after the other, as it mostly is one of the first; where there are hubs, in ever larger
  // steps, and then by bisection.
  constexpr Index kOneByOne = 16;
  Index failed = bound - 1, reached = delaunay, step = 1;
  Index tries = 0;
  for (Index most = bound; most < reached && !deadline.passed(); most += step) {
    (can_keep_below(most) ? reached : failed) = most;
    if (++tries >= kOneByOne) step *= 2;
  }
  while (failed + 1 < reached && !deadline.passed()) {
    const Index most = failed + (reached - failed) / 2;
    (can_keep_below(most) ? reached : failed) = most;
  }
  for (std::size_t q = 0; q < diagonals.size(); ++q)
    if (chosen[q]) flips.push_back(diagonals[q]);
  return bound;
}

/// The fixed edges at a vertex are always there.
Index fixed_bound(const DelaunayGraph& graph, Index order, const Deadline& deadline) {
  const Buffer<bool> fixed = fixed_edges(graph, order, deadline);
  Buffer<Index> degrees = degrees_of(graph.mesh);
  for (Index i = 0; i < fixed.size(); ++i)
    if (!fixed[i]) --degrees[graph.mesh.origin(HalfEdgeId(i))];  // none is on the boundary
  return largest(degrees);
}

}  // namespace

MeasuredSolution minimize_degree(const DelaunayGraph& graph, Index order,
                                 const Deadline& deadline) {
  const auto delaunay = largest(degrees_of(graph.mesh));
  std::vector<HalfEdgeId> flips;
  Index bound = order == 0 ? delaunay : choose_diagonals(graph, deadline, flips);
  MeshChange change(std::move(flips));
  TriangleMesh mesh = change.applied_to(graph.mesh);
  if (order > 1) {
    // From order to order: what is good at one is a good start at the next, and never lost.
    for (Index k = 2; k < std::min(order, kStepwise) && !deadline.passed(); ++k)
      reduce_degrees_by_flips(graph, k, deadline, mesh);
    reduce_degrees_by_flips(graph, order, deadline, mesh);
    bound = average_degree(graph.mesh);
    try {
      bound = std::max(bound, fixed_bound(graph, order, deadline));
      if (bound < largest(degrees_of(mesh)) && order <= kMostForBound)
        bound = degree_bound(graph, order, bound, deadline);
    } catch (const TimeIsUp&) {  // the bound so far is one
    }
  }
  const Index result = largest(degrees_of(mesh));
  if (order > 1) change = MeshChange(std::move(mesh));
  return {.change = std::move(change),
          .delaunay = double(delaunay),
          .result = double(result),
          .bound = double(bound),
          .is_optimal = result == bound};
}

}  // namespace hodt
