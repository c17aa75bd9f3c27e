#include "hodt/hydrology/rising_lakes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

namespace hodt {

namespace {

bool is_finite(const Rise& rise) {
  return std::all_of(rise.of_power.begin(), rise.of_power.end(),
                     [](double c) { return std::isfinite(c); });
}

int highest_difference(std::size_t a, std::size_t b) {
  return std::bit_width(a ^ b);
}

}  // namespace

RisingLakes::RisingLakes(const TriangleMesh& mesh, std::span<const Point> xy,
                         std::span<const double> z, std::span<const double> levels)
    : mesh_(mesh),
      xy_(xy),
      z_(z),
      levels_(levels),
      outgoing_(outgoing_halfedges(mesh)),
      order_(z.size()),
      parent_(z.size(), kNone),
      lake_(z.size()),
      next_(mesh.triangle_count()) {
  std::iota(order_.begin(), order_.end(), Index(0));
  std::sort(order_.begin(), order_.end(),
            [&](Index a, Index b) { return z[a] < z[b] || (z[a] == z[b] && a < b); });
  if (!levels.empty()) unit_ = levels.back() - z[order_.front()];
}

void RisingLakes::rise() {
  step_ = next_step_++;
  while (flooded_ < order_.size() && z_[order_[flooded_]] < levels_[step_])
    flood(VertexId(order_[flooded_++]));
}

double RisingLakes::volume_at(VertexId v) {
  Lake& lake = lake_of(v);
  come_up(lake);
  double volume = lake.full.of_power[0];
  for (const Group& group : lake.groups) volume += group.water.of_power[0];
  return volume;
}

Index RisingLakes::find(Index v) {
  while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
  return v;
}

/// A vertex brings the triangles of which it is the lowest corner; of level ones the first is.
void RisingLakes::flood(VertexId v) {
  parent_[v] = v;
  lake_[v] = kNone;
  for_each_neighbour(mesh_, outgoing_[v], [&](VertexId w) {
    if (parent_[w] != kNone) join(w, v);
  });
  if (lake_[find(v)] == kNone) {
    lake_[v] = static_cast<Index>(lakes_.size());
    lakes_.push_back({step_, {}, {}});
  }
  Lake& lake = lake_of(v);
  come_up(lake);
  const auto is_later = [&](VertexId w) { return z_[v] < z_[w] || (z_[v] == z_[w] && v < w); };
  for_each_outgoing(mesh_, outgoing_[v], [&](HalfEdgeId h) {
    if (is_later(mesh_.target(h)) && is_later(mesh_.apex(h))) add(lake, TriangleMesh::triangle(h));
  });
}

/// The lake of b, which may have none yet, becomes a part of that of a.
void RisingLakes::join(Index a, Index b) {
  a = find(a);
  b = find(b);
  if (a == b) return;
  parent_[b] = a;
  if (lake_[b] == kNone) return;
  Lake &to = lakes_[lake_[a]], from = std::exchange(lakes_[lake_[b]], {});
  come_up(to);
  come_up(from);
  to.full += from.full;
  for (const Group& group : from.groups) add_group(to, group);
}

/// Counts a lake's water from the present level.
void RisingLakes::come_up(Lake& lake) {
  if (lake.step == step_) return;
  const double up = (levels_[step_] - levels_[lake.step]) / unit_;
  const int turned = highest_difference(lake.step, step_);
  lake.step = step_;
  lake.full = lake.full.from(up);
  const std::vector<Group> groups = std::exchange(lake.groups, {});
  for (const Group& group : groups)
    if (group.bit > turned)
      lake.groups.push_back({group.bit, group.water.from(up), group.first, group.last});
  for (const Group& group : groups) {
    if (group.bit > turned) continue;
    for (Index t = group.first, next = kNone; t != kNone; t = next) {
      next = next_[t];
      add(lake, TriangleId(t));
    }
  }
}

void RisingLakes::add(Lake& lake, TriangleId t) {
  const WetTriangle triangle(mesh_, t, xy_, z_);
  const double level = levels_[step_], corner = triangle.next_corner(level);
  Rise water = triangle.rise(level, unit_);
  if (std::isinf(corner)) {
    lake.full += water;
    return;
  }
  auto change = static_cast<std::size_t>(std::lower_bound(levels_.begin(), levels_.end(), corner) -
                                         levels_.begin());
  // Corners at nearly the same height make coefficients that no double holds: it is looked at anew
  // at the next level.
  if (!is_finite(water)) {
    water = {{triangle.volume(level), 0, 0, 0}};
    change = step_ + 1;
  }
  next_[t] = kNone;
  add_group(lake, {highest_difference(change, step_), water, t, t});
}

void RisingLakes::add_group(Lake& lake, const Group& group) {
  for (Group& mine : lake.groups) {
    if (mine.bit != group.bit) continue;
    mine.water += group.water;
    next_[mine.last] = group.first;
    mine.last = group.last;
    return;
  }
  lake.groups.push_back(group);
}

}  // namespace hodt
