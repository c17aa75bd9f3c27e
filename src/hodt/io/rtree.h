// The R-tree of a spatial index, packed in one go, in the form that SQLite stores it.
// Tested by tests/io/feature_file_test.cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include "hodt/base/buffer.h"
#include "hodt/geometry/point.h"

namespace hodt {

/// A box of single precision that contains one of double precision.
struct SmallBox {
  float min_x, max_x, min_y, max_y;
};

SmallBox small_box(const Box& box);

/// Where the nodes and their links go, one level of the tree after another.
struct RtreeTaker {
  /// Nodes first, first + 1 and so on, one behind the other. Node 1 is the root.
  std::function<void(std::int64_t first, std::string_view bytes)> nodes;
  /// In which nodes entries first, first + 1 and so on are, or nodes but the root.
  using Links = std::function<void(std::int64_t first, std::span<const std::int64_t> nodes)>;
  Links entries;
  Links parents;
};

/// Packs boxes; entry i + 1 is boxes[i]. Every node has node_size bytes.
void pack_rtree(std::span<const SmallBox> boxes, std::size_t node_size, const RtreeTaker& taker);

}  // namespace hodt
