// One face of the fixed edges, to be triangulated as well as possible.
// Tested by tests/optimize/optimize_measure_test.cpp.
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/optimize/aggregator.h"

namespace hodt {

/// A valid triangle in the face, counter-clockwise, and its value.
struct FaceTriangle {
  std::array<VertexId, 3> corners;
  double value = 0;
};

struct FaceProblem {
  std::span<const FaceTriangle> triangles;
  /// The sides of the face: fixed edges, with the face on their left.
  std::span<const std::pair<VertexId, VertexId>> sides;
  /// How many triangles any triangulation of the face has.
  std::size_t size = 0;
  /// What a triangulation at hand has for a value.
  double value = 0;
};

struct FaceSolution {
  /// Indices of the triangles, or none if no triangulation was found.
  std::vector<Index> chosen;
  /// No triangulation of the face is better, sums being exact ones.
  double bound = 0;
  /// By sums to minimize: how much less each triangle could cost, all of them at once, and the
  /// bound be the same, about. Or nothing.
  std::vector<double> spare = {};
};

}  // namespace hodt
