// The faces of the fixed edges, each with its valid triangles.
// Tested by tests/optimize/optimize_measure_test.cpp.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "hodt/base/buffer.h"
#include "hodt/base/deadline.h"
#include "hodt/optimize/aggregator.h"
#include "hodt/optimize/triangle_measure/face_problem.h"
#include "hodt/optimize/triangle_measure/face_program.h"
#include "hodt/optimize/triangle_measure/polygon_optimum.h"
#include "hodt/order/fixed_edges.h"

namespace hodt {

/// Every triangulation of order k has the fixed edges (Silveira and van Kreveld), so each of its
/// triangles, all of them valid, is in one face. A view: the graph must outlive it.
class Faces {
 public:
  /// Throws TimeIsUp if the deadline passes.
  Faces(const DelaunayGraph& graph, Index order, const Deadline& deadline);
  Faces(const Faces&) = delete;
  Faces& operator=(const Faces&) = delete;

  std::size_t size() const { return faces_.size(); }
  bool is_fixed(HalfEdgeId h) const { return fixed_[h]; }
  /// The Delaunay triangles of the face: so many it takes.
  std::span<const TriangleId> places(Index face) const { return faces_.triangles(face); }
  /// The valid triangles, values not set at first; of one face, or by faces.
  std::span<FaceTriangle> triangles(Index face) {
    return {triangles_.data() + first_[face], triangles_.data() + first_[face + 1]};
  }
  std::span<FaceTriangle> triangles() { return triangles_; }

  /// The best triangles for the face, for sums or largest or smallest values, and a bound: by
  /// dynamic programming if the face is a polygon, else by linear programs (`most_programs`),
  /// unless time is over. `value`: of a triangulation of the face at hand. A program that is made
  /// is left in `program`, if given, to begin with the next time.
  FaceSolution solve(Index face, const Aggregator& aggregator, double value,
                     const Deadline& deadline, std::size_t most_programs, PolygonOptimum& polygon,
                     std::unique_ptr<FaceProgram>* program = nullptr);

 private:
  Index face_of(const std::array<VertexId, 3>& corners) const;
  TriangleId beginning_at(VertexId v, VertexId w, Index most) const;

  const DelaunayGraph& graph_;
  const Buffer<bool> fixed_;
  const FixedFaces faces_;
  std::vector<FaceTriangle> triangles_;
  std::vector<std::size_t> first_;  // of each face
};

}  // namespace hodt
