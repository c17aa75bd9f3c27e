// What two triangles across an edge measure. A new measure is one more function here, and a name in
// objective; one's own is an OwnEdgeMeasure.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "hodt/base/buffer.h"
#include "hodt/geometry/point.h"
#include "hodt/mesh/triangle_mesh.h"
#include "hodt/optimize/aggregator.h"

namespace hodt {

/// Values of inner edges for an objective with an EdgeMeasure. A view: the points and heights must
/// outlive it.
class EdgeValues : public Aggregator {
 public:
  EdgeValues(const Objective& objective, std::span<const Point> xy, std::span<const double> z);

  /// What a measure needs to know of a triangle: the gradient of the plane through its corners, the
  /// same bits whatever corner comes first. A measure of one's own needs the corners themselves.
  struct Gradient {
    double x, y;

    /// Keeps three corners instead, so that two of them tell the third one.
    static Gradient of_corners(VertexId a, VertexId b, VertexId c) {
      return {static_cast<double>(a ^ b ^ c), 0};
    }
    VertexId other_corner(VertexId a, VertexId b) const {
      return VertexId(static_cast<Index>(x) ^ a ^ b);
    }
  };
  /// Throws InputError if a double cannot hold it.
  Gradient gradient(VertexId a, VertexId b, VertexId c) const;
  /// Those of all triangles of a mesh.
  Buffer<Gradient> gradients(const TriangleMesh& mesh) const;

  /// The value of the edge ab between triangles with these gradients, f on its left; finite and
  /// never negative. The same bits from either side. Throws InputError if a double cannot hold it.
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

  /// From a to b.
  Point along(VertexId a, VertexId b) const { return {xy_[b].x - xy_[a].x, xy_[b].y - xy_[a].y}; }

 private:
  friend class ManyEdges;
  bool is_own() const { return measure_.kind == EdgeMeasure::own; }
  Gradient exact_gradient(Index a, Index b, Index c) const;
  std::array<VertexId, 4> own_corners(VertexId a, VertexId b, const Gradient& f,
                                      const Gradient& g) const;
  std::array<Corner, 4> places(const std::array<VertexId, 4>& corners) const;
  double checked(double value, const std::array<VertexId, 4>& corners) const;
  double own_value(VertexId a, VertexId b, const Gradient& f, const Gradient& g) const;
  double wide_value(VertexId a, VertexId b, const Gradient& f, const Gradient& g) const;

  EdgeMeasure measure_;
  bool is_wide_;  // no double holds all squares and products of coordinates and heights
  std::span<const Point> xy_;
  std::span<const double> z_;
};

/// EdgeValues::across for many edges side by side, each between one of two gradients on its left
/// and one of two on its right: the same bits, in a fraction of the time.
class ManyEdges {
 public:
  static constexpr std::size_t kSize =
      124;  // no power of two: see order/first_order/nearest_beyond.cpp
  using Gradients = std::array<EdgeValues::Gradient, 2>;

  explicit ManyEdges(const EdgeValues& values) : values_(values) {}

  /// Edge i, from a to b.
  void set(std::size_t i, VertexId a, VertexId b, const Gradients& left, const Gradients& right) {
    set(i, a, b, left[0], right[0]);
    left_[1].set(i, left[1]);
    right_[1].set(i, right[1]);
  }
  /// The same, to be measured for gradients 0 alone.
  void set(std::size_t i, VertexId a, VertexId b, const EdgeValues::Gradient& left,
           const EdgeValues::Gradient& right) {
    const auto [x, y] = values_.along(a, b);
    ends_[i] = {a, b};
    x_[i] = x;
    y_[i] = y;
    left_[0].set(i, left);
    right_[0].set(i, right);
  }
  /// The values of the first so many, for the gradients of these numbers.
  const double* measure(std::size_t size, int left, int right);

 private:
  using Column = std::array<double, kSize>;
  struct GradientColumns {
    Column x, y;
    void set(std::size_t i, const EdgeValues::Gradient& g) {
      x[i] = g.x;
      y[i] = g.y;
    }
    EdgeValues::Gradient at(std::size_t i) const { return {x[i], y[i]}; }
  };

  void ask(std::size_t size, int left, int right);
  double one(std::size_t i, int left, int right) const {
    return values_.across(ends_[i][0], ends_[i][1], left_[left].at(i), right_[right].at(i));
  }

  const EdgeValues& values_;
  std::array<std::array<VertexId, 2>, kSize> ends_;
  Column x_, y_;
  std::array<GradientColumns, 2> left_, right_;
  std::array<std::array<Column, 2>, 2> value_;
};

}  // namespace hodt
