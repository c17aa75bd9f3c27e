// A triangulation that edges are brought into, with its local extrema known throughout.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "hodt/base/buffer.h"
#include "hodt/base/deadline.h"
#include "hodt/geometry/heights.h"
#include "hodt/optimize/objective.h"
#include "hodt/order/constrained/constrained_triangulation.h"

namespace hodt {

/// What every vertex of a mesh is an extremum of, as far as the objective counts it: one bit a
/// kind.
Buffer<std::uint8_t> extrema_of(const TriangleMesh& mesh, const Heights& heights,
                                Objective objective);
/// How many extrema these are: a vertex may be two.
std::size_t count_extrema(std::span<const std::uint8_t> extrema);

/// A flag for every vertex: a local minimum among these that has to stay one. `keep` has a flag for
/// every vertex, or none at all.
Buffer<bool> kept_minima(std::span<const std::uint8_t> extrema, std::span<const bool> keep);

/// It starts as the Delaunay triangulation.
class ExtremaTriangulation {
 public:
  /// `keep`: vertices that have to stay local minima if they are such at the start, one flag each,
  /// or none at all.
  ExtremaTriangulation(const DelaunayGraph& graph, const Heights& heights, Objective objective,
                       std::span<const bool> keep);

  const ConstrainedTriangulation& triangulation() const { return triangulation_; }
  TriangleMesh take_mesh() && { return std::move(triangulation_).take_mesh(); }

  bool is_extremum(VertexId v, Extremum kind) const { return extrema_[v] & bit(kind); }
  std::size_t extrema() const { return count_extrema(extrema_); }
  /// A flag for every vertex: a local minimum of the Delaunay triangulation that has to stay one.
  const Buffer<bool>& kept() const { return kept_; }
  bool keeps_all() const;

  /// Locks the edge if it takes the place of Delaunay triangles only, fewer extrema are left then,
  /// and none is lost that has to stay. Otherwise nothing changes.
  void lock_if_better(VertexId owner, VertexId to);

  /// The other end of the locked edge that each vertex owns, or kNone.
  Buffer<Index> partners() const;
  /// Makes the locked edges be just these. Throws TimeIsUp if the deadline passes, and is of no use
  /// then.
  void hold(const Buffer<Index>& partners, const Deadline& deadline = {});

  /// Changes the triangulation as told.
  template <class Change>
  void edit(const Change& change) {
    const auto before = triangulation_.now();
    change(triangulation_);
    find_changed_corners(before);
    for (const VertexId v : corners_) extrema_[v] = extrema_at(v);
    triangulation_.commit();
  }

 private:
  bool is_better(ConstrainedTriangulation::Moment since);
  void find_changed_corners(ConstrainedTriangulation::Moment since);
  std::uint8_t extrema_at(VertexId v) const;

  const Heights heights_;
  const Objective objective_;
  ConstrainedTriangulation triangulation_;
  Buffer<std::uint8_t> extrema_;
  Buffer<bool> kept_;

  // Of the last change.
  std::vector<TriangleId> changed_;
  std::vector<VertexId> corners_;
};

}  // namespace hodt
