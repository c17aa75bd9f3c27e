// Every edge given to one of its ends.
#pragma once

#include <cstddef>
#include <span>

#include "hodt/base/buffer.h"
#include "hodt/order/crossings.h"

namespace hodt {

/// For every vertex the other end of the edge that it owns, or kNone: each edge is owned by one of
/// its ends, and each vertex owns one edge at most. Where edges that hang together outnumber their
/// ends, the last ones have no owner. O(vertices + edges).
Buffer<Index> edge_owners(std::size_t vertices, std::span<const PlainEdge> edges);

}  // namespace hodt
