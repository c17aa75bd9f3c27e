// 32-bit ids: an index that knows what it indexes.
//
// An id converts to a plain number by itself (so it can index an array), but a number becomes an
// id only when written out, and one kind of id never becomes another.
// Tested by tests/mesh/triangle_mesh_test.cpp.
#pragma once

#include <cstdint>
#include <limits>

namespace hodt {

using Index = std::uint32_t;

/// The index that means "none": no neighbour across a boundary edge, no vertex found.
inline constexpr Index kNone = std::numeric_limits<Index>::max();

template <class Tag>
class Id {
 public:
  constexpr Id() = default;
  constexpr explicit Id(Index index) : index_(index) {}
  constexpr operator Index() const { return index_; }
  constexpr bool valid() const { return index_ != kNone; }

 private:
  Index index_ = kNone;
};

using VertexId = Id<struct VertexTag>;
using TriangleId = Id<struct TriangleTag>;
/// Half-edge 3t + i runs from corner i of triangle t to the next corner, counter-clockwise.
using HalfEdgeId = Id<struct HalfEdgeTag>;

}  // namespace hodt
