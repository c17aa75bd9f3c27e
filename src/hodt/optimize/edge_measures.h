// What two triangles across an edge measure. A new measure is one more function here, and a name in
// objective.
#pragma once

#include <span>

#include "hodt/base/buffer.h"
#include "hodt/geometry/point.h"
#include "hodt/mesh/triangle_mesh.h"
#include "hodt/optimize/combination.h"

namespace hodt {

/// Values of inner edges for an objective whose measure is_of_edges. A view: the points and heights
/// must outlive it.
class EdgeValues : public Combination {
 public:
  EdgeValues(const Objective& objective, std::span<const Point> xy, std::span<const double> z)
      : Combination(objective), xy_(xy), z_(z) {}

  /// The gradient of the plane through three points: the same bits whatever corner comes first.
  struct Gradient {
    double x, y;
  };
  Gradient gradient(VertexId a, VertexId b, VertexId c) const;
  /// Those of all triangles of a mesh.
  Buffer<Gradient> gradients(const TriangleMesh& mesh) const;

  /// The value of the edge ab between triangles with these gradients; never negative, at most
  /// 1e150. The same bits from either side.
  double across(VertexId a, VertexId b, const Gradient& f, const Gradient& g) const;
  /// The same with the triangles abc, on the left, and bad.
  double of(VertexId a, VertexId b, VertexId c, VertexId d) const {
    return across(a, b, gradient(a, b, c), gradient(b, a, d));
  }
  /// The same of an edge of a mesh that is not on the boundary.
  double of(const TriangleMesh& mesh, HalfEdgeId h) const {
    return of(mesh.origin(h), mesh.target(h), mesh.apex(h), mesh.apex(mesh.twin(h)));
  }
  /// The objective's value of a triangulation; 0 if it has no inner edge.
  double of(const TriangleMesh& mesh) const;

 private:
  std::span<const Point> xy_;
  std::span<const double> z_;
};

}  // namespace hodt
