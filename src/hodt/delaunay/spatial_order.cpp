#include "hodt/delaunay/spatial_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"

namespace hodt {

namespace {

constexpr std::size_t kGrain = 1 << 15;
constexpr std::size_t kComparisonSort = 48;  // below this size insertion beats another radix pass

struct Item {
  std::uint64_t key;
  Index row;
};

struct Box {
  double min_x = std::numeric_limits<double>::infinity();
  double min_y = std::numeric_limits<double>::infinity();
  double max_x = -std::numeric_limits<double>::infinity();
  double max_y = -std::numeric_limits<double>::infinity();
};

void require_finite(const PointView& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& p = points.xy[i];
    const bool height_ok = !points.has_heights() || std::isfinite(points.z[i]);
    if (std::isfinite(p.x) && std::isfinite(p.y) && height_ok) continue;
    throw InputError(fmt::format(
        "point {} (counted from 0) has a coordinate that is not finite; remove it or give a number",
        i));
  }
}

/// The bounding box, and whether everything is finite: a sum with NaN or infinity in it is not.
Box bounding_box(const PointView& points) {
  const std::size_t pieces = (points.size() + kGrain - 1) / kGrain;
  std::vector<Box> boxes(pieces);
  std::vector<double> poison(pieces);
  parallel_for(0, pieces, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t piece = first; piece < last; ++piece) {
      Box box;
      double zeros = 0;  // x * 0 is NaN exactly for NaN and infinity
      const std::size_t end = std::min(points.size(), (piece + 1) * kGrain);
      for (std::size_t i = piece * kGrain; i < end; ++i) {
        const Point p = points.xy[i];
        zeros += p.x * 0 + p.y * 0;
        box.min_x = std::min(box.min_x, p.x);
        box.max_x = std::max(box.max_x, p.x);
        box.min_y = std::min(box.min_y, p.y);
        box.max_y = std::max(box.max_y, p.y);
      }
      if (points.has_heights())
        for (std::size_t i = piece * kGrain; i < end; ++i) zeros += points.z[i] * 0;
      boxes[piece] = box;
      poison[piece] = zeros;
    }
  });
  Box all;
  double zeros = 0;
  for (std::size_t piece = 0; piece < pieces; ++piece) {
    zeros += poison[piece];
    all.min_x = std::min(all.min_x, boxes[piece].min_x);
    all.max_x = std::max(all.max_x, boxes[piece].max_x);
    all.min_y = std::min(all.min_y, boxes[piece].min_y);
    all.max_y = std::max(all.max_y, boxes[piece].max_y);
  }
  if (zeros != 0 || std::isnan(zeros)) require_finite(points);
  return all;
}

/// Spreads the 32 bits of v over the even bits of the result.
std::uint64_t spread(std::uint32_t v) {
  std::uint64_t s = v;
  s = (s | s << 16) & 0x0000FFFF0000FFFFu;
  s = (s | s << 8) & 0x00FF00FF00FF00FFu;
  s = (s | s << 4) & 0x0F0F0F0F0F0F0F0Fu;
  s = (s | s << 2) & 0x3333333333333333u;
  s = (s | s << 1) & 0x5555555555555555u;
  return s;
}

/// Maps coordinates to 32-bit cells. Rounding is monotone in each step, so cells never come in
/// another order than the coordinates: a cut between two cells is a straight line between the
/// points, which is all that correctness needs.
class Cells {
 public:
  explicit Cells(const Box& box) {
    // Halved, the extent of any finite doubles is finite.
    const double extent = std::max(box.max_x / 2 - box.min_x / 2, box.max_y / 2 - box.min_y / 2);
    shrink_ = extent < std::numeric_limits<double>::max() / 4 ? 1 : 0.5;
    min_x_ = box.min_x * shrink_;
    min_y_ = box.min_y * shrink_;
    scale_ = extent > 0 ? kLast / (2 * extent * shrink_) : 0;
    scale_ = std::min(scale_, std::numeric_limits<double>::max());
  }

  std::uint64_t key(const Point& p) const {
    return spread(cell(p.x * shrink_ - min_x_)) | spread(cell(p.y * shrink_ - min_y_)) << 1;
  }

 private:
  static constexpr double kLast = 4294967295.0;

  std::uint32_t cell(double offset) const {
    return static_cast<std::uint32_t>(std::min(offset * scale_, kLast));
  }

  double shrink_, min_x_, min_y_, scale_;
};

void insertion_sort(Item* items, std::size_t size) {
  for (std::size_t i = 1; i < size; ++i) {
    const Item item = items[i];
    std::size_t j = i;
    for (; j > 0 && item.key < items[j - 1].key; --j) items[j] = items[j - 1];
    items[j] = item;
  }
}

/// Radix sort from the top: after a pass by the 8 bits below `shift`, each bucket is sorted on its
/// own, so that clustered points cost passes only where they are clustered. `spare` is as large as
/// `items`.
void sort_items(Item* items, Item* spare, std::size_t size, int shift) {
  if (size <= kComparisonSort || shift <= 0) {
    insertion_sort(items, size);
    return;
  }
  const int low = std::max(0, shift - 8);
  const auto digit = [low](const Item& item) { return (item.key >> low) & 0xFF; };
  std::array<std::uint32_t, 257> start{};
  for (std::size_t i = 0; i < size; ++i) ++start[digit(items[i]) + 1];
  for (int d = 0; d < 256; ++d) start[d + 1] += start[d];
  std::array<std::uint32_t, 257> end = start;
  for (std::size_t i = 0; i < size; ++i) spare[end[digit(items[i])]++] = items[i];
  std::copy(spare, spare + size, items);
  for (int d = 0; d < 256; ++d) {
    const std::size_t first = start[d], count = start[d + 1] - first;
    if (count > 1) sort_items(items + first, spare + first, count, low);
  }
}

/// The first pass, by the top bits and in parallel: pieces of the input are counted and then moved
/// one after the other, which keeps the pass stable and its result independent of the threads.
Buffer<Item> sorted_items(const PointView& points, const Cells& cells) {
  const std::size_t n = points.size();
  const int bits = std::clamp(static_cast<int>(std::bit_width(n)) - 7, 1, 12);
  const int shift = 64 - bits;
  const std::size_t buckets = std::size_t{1} << bits;
  const std::size_t pieces = std::clamp<std::size_t>(n / kGrain, 1, 16);
  const auto begin_of = [&](std::size_t piece) { return n * piece / pieces; };

  Buffer<Item> items(n), sorted(n);
  std::vector<std::uint32_t> place(pieces * buckets, 0);
  parallel_for(0, pieces, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t piece = first; piece < last; ++piece) {
      std::uint32_t* count = &place[piece * buckets];
      for (std::size_t i = begin_of(piece); i < begin_of(piece + 1); ++i) {
        items[i] = {cells.key(points.xy[i]), static_cast<Index>(i)};
        ++count[items[i].key >> shift];
      }
    }
  });
  std::vector<std::uint32_t> bucket_start(buckets + 1, 0);
  std::uint32_t sum = 0;
  for (std::size_t b = 0; b < buckets; ++b) {
    bucket_start[b] = sum;
    for (std::size_t piece = 0; piece < pieces; ++piece) {
      const std::uint32_t count = place[piece * buckets + b];
      place[piece * buckets + b] = sum;
      sum += count;
    }
  }
  bucket_start[buckets] = sum;
  parallel_for(0, pieces, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t piece = first; piece < last; ++piece) {
      std::uint32_t* to = &place[piece * buckets];
      for (std::size_t i = begin_of(piece); i < begin_of(piece + 1); ++i)
        sorted[to[items[i].key >> shift]++] = items[i];
    }
  });
  parallel_for(
      0, buckets, std::max<std::size_t>(1, buckets / 64), [&](std::size_t first, std::size_t last) {
        for (std::size_t b = first; b < last; ++b) {
          const std::size_t at = bucket_start[b];
          sort_items(sorted.data() + at, items.data() + at, bucket_start[b + 1] - at, shift);
        }
      });
  return sorted;
}

/// Sorts runs of equal keys lexicographically, lowest duplicate first, and drops the other
/// duplicates, noting their heights. Returns how many items are left.
std::size_t order_within_cells(const PointView& points, Buffer<Item>& items,
                               DuplicateHeights& heights) {
  const auto before = [&](const Item& a, const Item& b) {
    const Point &p = points.xy[a.row], &q = points.xy[b.row];
    if (p.x != q.x || p.y != q.y) return lexicographically_less(p, q);
    if (points.has_heights() && points.z[a.row] != points.z[b.row])
      return points.z[a.row] < points.z[b.row];
    return a.row < b.row;
  };
  const auto note = [&](const Item& dropped, const Item& stays) {
    if (!points.has_heights()) return;
    const double difference = points.z[dropped.row] - points.z[stays.row];
    if (difference > 0) ++heights.different;
    heights.largest_difference = std::max(heights.largest_difference, difference);
  };
  std::size_t kept = 0;
  for (std::size_t first = 0; first < items.size();) {
    std::size_t last = first + 1;
    while (last < items.size() && items[last].key == items[first].key) ++last;
    if (last - first == 1) {
      items[kept++] = items[first];
    } else {
      std::sort(items.data() + first, items.data() + last, before);
      for (std::size_t i = first; i < last; ++i) {
        const bool duplicate =
            i > first && points.xy[items[i].row] == points.xy[items[kept - 1].row];
        if (duplicate)
          note(items[i], items[kept - 1]);
        else
          items[kept++] = items[i];
      }
    }
    first = last;
  }
  return kept;
}

}  // namespace

SpatialOrder spatial_order(const PointView& points) {
  if (points.size() > kMaxPoints)
    throw InputError(fmt::format(
        "{} points are more than the {} that one triangulation can hold; split the input",
        points.size(), kMaxPoints));
  const Cells cells(bounding_box(points));
  Buffer<Item> items = sorted_items(points, cells);
  SpatialOrder order;
  const std::size_t n = order_within_cells(points, items, order.vertices.duplicate_heights);
  order.key = Buffer<std::uint64_t>(n);
  order.vertices.xy = Buffer<Point>(n);
  order.vertices.row = Buffer<Index>(n);
  if (points.has_heights()) order.vertices.z = Buffer<double>(n);
  parallel_for(0, n, kGrain, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      order.key[i] = items[i].key;
      order.vertices.row[i] = items[i].row;
      order.vertices.xy[i] = points.xy[items[i].row];
      if (points.has_heights()) order.vertices.z[i] = points.z[items[i].row];
    }
  });
  return order;
}

Buffer<VertexId> vertices_of_rows(const PointView& points, const VertexSet& vertices) {
  Buffer<VertexId> vertex_of(points.size(), VertexId());
  for (Index v = 0; v < vertices.size(); ++v) vertex_of[vertices.row[v]] = VertexId(v);
  if (vertices.size() == points.size()) return vertex_of;

  // Duplicates find their vertex by search in lexicographic order.
  std::vector<Index> sorted(vertices.size());
  for (Index v = 0; v < sorted.size(); ++v) sorted[v] = v;
  std::sort(sorted.begin(), sorted.end(), [&](Index a, Index b) {
    return lexicographically_less(vertices.xy[a], vertices.xy[b]);
  });
  for (std::size_t row = 0; row < points.size(); ++row) {
    if (vertex_of[row].valid()) continue;
    const auto same = std::lower_bound(
        sorted.begin(), sorted.end(), points.xy[row],
        [&](Index v, const Point& p) { return lexicographically_less(vertices.xy[v], p); });
    vertex_of[row] = VertexId(*same);
  }
  return vertex_of;
}

}  // namespace hodt
