// What lakes hold while the water rises and they grow together.
// Tested by tests/hydrology/pit_water_test.cpp.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hodt/base/buffer.h"
#include "hodt/base/ids.h"
#include "hodt/hydrology/wet_triangle.h"
#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

/// The lakes of a terrain whose water stands at one level after the other. At a level, a lake is
/// connected vertices that are lower, and it covers what of the triangles around them is lower.
///
/// A lake keeps its volume as polynomials of the level, each of triangles that no corner changes
/// for the same time: of those that change at the step `s`, now being step `n`, a lake has one for
/// each highest bit in which s and n differ (as in a radix heap). At that bit's turn the triangles
/// are handed on to lower bits, so that each moves a logarithm of times, and the polynomials of two
/// lakes are added when they join. With m levels O((n + m) log (n + m)), however tall triangles
/// are.
class RisingLakes {
 public:
  /// The levels ascend strictly. Keeps references.
  RisingLakes(const TriangleMesh& mesh, std::span<const Point> xy, std::span<const double> z,
              std::span<const double> levels);

  /// Lets the water rise to the next level, the first one at first.
  void rise();
  /// Of the lake that a vertex below the water is in.
  double volume_at(VertexId v);

 private:
  struct Group {
    int bit;
    Rise water;
    Index first, last;  ///< of a list of triangles
  };
  struct Lake {
    std::size_t step;  ///< from whose level its water is counted
    Rise full;         ///< over triangles that are under water
    std::vector<Group> groups;
  };

  Index find(Index v);
  Lake& lake_of(Index v) { return lakes_[lake_[find(v)]]; }
  void flood(VertexId v);
  void join(Index a, Index b);
  void come_up(Lake& lake);
  void add(Lake& lake, TriangleId t);
  void add_group(Lake& lake, const Group& group);

  const TriangleMesh& mesh_;
  std::span<const Point> xy_;
  std::span<const double> z_;
  std::span<const double> levels_;
  Buffer<HalfEdgeId> outgoing_;
  double unit_ = 1;           // of heights, so that their powers neither overflow nor vanish
  std::vector<Index> order_;  // of vertices, the lowest first
  std::size_t flooded_ = 0;   // how many of them are under water
  std::size_t next_step_ = 0;
  std::size_t step_ = 0;
  Buffer<Index> parent_;  // sets of vertices; kNone of dry ones
  Buffer<Index> lake_;    // of each set
  std::vector<Lake> lakes_;
  Buffer<Index> next_;  // in a group's list
};

}  // namespace hodt
