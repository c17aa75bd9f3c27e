// The border of a mesh, as a list of edges.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "hodt/base/ids.h"

namespace hodt {

/// The edges that one triangle has, each in that triangle's direction, sorted: those that bound an
/// embedded mesh (see embedding.h) and its holes. O(n log n).
std::vector<std::array<Index, 2>> boundary_edges(std::span<const std::array<Index, 3>> triangles);

}  // namespace hodt
