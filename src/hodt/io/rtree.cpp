#include "hodt/io/rtree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/base/parallel.h"

namespace hodt {

namespace {

/// Of a node: its depth if it is the root, and its number of cells, two bytes each.
constexpr std::size_t kHeadSize = 4;
/// An entry and its box.
constexpr std::size_t kCellSize = 24;

template <class Unsigned>
char* put_big_endian(char* to, Unsigned value) {
  for (int shift = 8 * (sizeof value - 1); shift >= 0; shift -= 8)
    *to++ = static_cast<char>(value >> shift);
  return to;
}

float below(double value) {
  const float rounded = static_cast<float>(value);
  return rounded > value ? std::nextafter(rounded, -std::numeric_limits<float>::infinity())
                         : rounded;
}

SmallBox joined(const SmallBox& a, const SmallBox& b) {
  return {std::min(a.min_x, b.min_x), std::max(a.max_x, b.max_x), std::min(a.min_y, b.min_y),
          std::max(a.max_y, b.max_y)};
}

/// Boxes in tiles: cut along x into slices, these along y into nodes.
class Tiles {
 public:
  Tiles(std::span<const SmallBox> boxes, std::size_t capacity)
      : count_(boxes.size()), nodes_((count_ + capacity - 1) / capacity), order_(count_) {
    Buffer<Key> keys(count_);
    for (Index i = 0; i < count_; ++i) keys[i] = {boxes[i].min_x, i};
    std::sort(keys.begin(), keys.end());
    const std::size_t in_slice = std::size_t(std::ceil(std::sqrt(double(nodes_))));
    parallel_for(0, (nodes_ + in_slice - 1) / in_slice, 1, [&](std::size_t from, std::size_t to) {
      for (std::size_t slice = from; slice < to; ++slice) {
        const std::size_t first = begin_of(slice * in_slice);
        const std::size_t last = begin_of(std::min((slice + 1) * in_slice, nodes_));
        for (std::size_t i = first; i < last; ++i) keys[i].first = boxes[keys[i].second].min_y;
        std::sort(keys.begin() + first, keys.begin() + last);
        for (std::size_t i = first; i < last; ++i) order_[i] = keys[i].second;
      }
    });
  }

  std::size_t nodes() const { return nodes_; }
  /// The boxes of a node, as evenly many as can be.
  std::span<const Index> of_node(std::size_t node) const {
    return std::span<const Index>(order_).subspan(begin_of(node),
                                                  begin_of(node + 1) - begin_of(node));
  }

 private:
  struct Key {
    float first;
    Index second;
    bool operator<(const Key& other) const {
      return first < other.first || (first == other.first && second < other.second);
    }
  };
  std::size_t begin_of(std::size_t node) const { return node * count_ / nodes_; }

  std::size_t count_;
  std::size_t nodes_;
  Buffer<Index> order_;
};

char* put_cell(char* to, std::int64_t entry, const SmallBox& box) {
  to = put_big_endian(to, static_cast<std::uint64_t>(entry));
  for (const float side : {box.min_x, box.max_x, box.min_y, box.max_y})
    to = put_big_endian(to, std::bit_cast<std::uint32_t>(side));
  return to;
}

}  // namespace

SmallBox small_box(const Box& box) {
  return {below(box.low.x), -below(-box.high.x), below(box.low.y), -below(-box.high.y)};
}

void pack_rtree(std::span<const SmallBox> boxes, std::size_t node_size, const RtreeTaker& taker) {
  if (boxes.empty()) return;
  const std::size_t capacity = (node_size - kHeadSize) / kCellSize;
  std::vector<SmallBox> below_boxes(boxes.begin(), boxes.end());
  std::int64_t first_below = 1, next = 2;
  for (std::uint16_t depth = 0;; ++depth) {
    const Tiles tiles(below_boxes, capacity);
    const bool is_root = tiles.nodes() == 1;
    const std::int64_t first = is_root ? 1 : next;
    std::vector<SmallBox> node_boxes(tiles.nodes());
    Buffer<std::int64_t> node_of(below_boxes.size());
    Buffer<char> bytes(tiles.nodes() * node_size);
    parallel_for(0, tiles.nodes(), 64, [&](std::size_t from, std::size_t to) {
      for (std::size_t n = from; n < to; ++n) {
        const std::span<const Index> members = tiles.of_node(n);
        char* const start = bytes.data() + n * node_size;
        char* end = put_big_endian(start, is_root ? depth : std::uint16_t{0});
        end = put_big_endian(end, static_cast<std::uint16_t>(members.size()));
        SmallBox box = below_boxes[members[0]];
        for (const Index i : members) {
          end = put_cell(end, first_below + i, below_boxes[i]);
          node_of[i] = first + std::int64_t(n);
          box = joined(box, below_boxes[i]);
        }
        std::fill(end, start + node_size, '\0');
        node_boxes[n] = box;
      }
    });
    taker.nodes(first, {bytes.data(), bytes.size()});
    (depth == 0 ? taker.entries : taker.parents)(first_below, node_of);
    if (is_root) return;
    next += std::int64_t(tiles.nodes());
    first_below = first;
    below_boxes = std::move(node_boxes);
  }
}

}  // namespace hodt
