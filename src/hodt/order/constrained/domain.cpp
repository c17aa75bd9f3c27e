#include "hodt/order/constrained/domain.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/geometry/direction.h"
#include "hodt/mesh/find_outgoing.h"

namespace hodt {

namespace {

class Restrictor {
 public:
  explicit Restrictor(Delaunay& delaunay)
      : delaunay_(delaunay),
        xy_(delaunay.vertices.xy),
        mesh_(delaunay.mesh),
        is_kept_(delaunay.mesh.triangle_count(), true) {}

  std::size_t leave_out_outside(std::span<const std::array<VertexId, 2>> boundary);
  std::size_t leave_out_too_long(double max_edge);
  /// Numbers what is left anew; returns the number of vertices that nothing has.
  std::size_t renumber() &&;

 private:
  void check_closed(std::span<const std::array<VertexId, 2>> boundary) const;
  Buffer<bool> bounding(std::span<const std::array<VertexId, 2>> boundary) const;
  bool is_at_border(HalfEdgeId h) const {
    const HalfEdgeId twin = mesh_.twin(h);
    return !twin.valid() || !is_kept_[TriangleMesh::triangle(twin)];
  }
  std::vector<Index> fans(Buffer<Index>& fan_of) const;
  bool is_empty() const {
    return std::find(is_kept_.begin(), is_kept_.end(), true) == is_kept_.end();
  }

  Delaunay& delaunay_;
  const std::span<const Point> xy_;
  const TriangleMesh& mesh_;
  Buffer<bool> is_kept_;
};

// ---- Inside and outside. ----

/// A border that ends somewhere has no inside.
void Restrictor::check_closed(std::span<const std::array<VertexId, 2>> boundary) const {
  Buffer<bool> is_odd(xy_.size(), false);
  for (const auto& [a, b] : boundary) is_odd[a] = !is_odd[a], is_odd[b] = !is_odd[b];
  for (Index v = 0; v < is_odd.size(); ++v)
    if (is_odd[v])
      throw InputError(fmt::format(
          "the boundary ends at row {} (x {}, y {}), counted from 0; it has to be closed",
          delaunay_.vertices.row[v], xy_[v].x, xy_[v].y));
}

/// Of every half-edge whether its edge bounds the domain: an odd number of times.
Buffer<bool> Restrictor::bounding(std::span<const std::array<VertexId, 2>> boundary) const {
  const Buffer<HalfEdgeId> outgoing = outgoing_halfedges(mesh_);
  Buffer<bool> bounds(mesh_.halfedge_count(), false);
  const auto on_the_way = [&](VertexId from, VertexId to) {
    const Point &a = xy_[from], &b = xy_[to];
    HalfEdgeId along;
    find_outgoing(mesh_, outgoing[from], kNone, [&](HalfEdgeId h) {
      const auto is_it = [&](HalfEdgeId g, VertexId v) {
        if (!delaunay_.walls[g] || !is_same_direction(a, b, xy_[v])) return false;
        along = g;
        return true;
      };
      const HalfEdgeId last = TriangleMesh::prev(h);
      return is_it(h, mesh_.target(h)) ||
             (mesh_.is_boundary(last) && is_it(last, mesh_.origin(last)));
    });
    return along;
  };
  for (const auto& [a, b] : boundary)
    for (VertexId v = a; v != b;) {
      const HalfEdgeId h = on_the_way(v, b), twin = mesh_.twin(h);
      bounds[h] = !bounds[h];
      if (twin.valid()) bounds[twin] = bounds[h];
      v = mesh_.origin(h) == v ? mesh_.target(h) : mesh_.origin(h);
    }
  return bounds;
}

/// From the hull inward, changing sides at each edge that bounds the domain.
std::size_t Restrictor::leave_out_outside(std::span<const std::array<VertexId, 2>> boundary) {
  if (boundary.empty()) return 0;
  check_closed(boundary);
  const Buffer<bool> bounds = bounding(boundary);
  Buffer<bool> is_known(mesh_.triangle_count(), false);
  std::vector<TriangleId> open;
  const auto reach = [&](TriangleId t, bool is_inside) {
    if (std::exchange(is_known[t], true)) return;
    is_kept_[t] = is_inside;
    open.push_back(t);
  };
  for (Index i = 0; i < mesh_.halfedge_count(); ++i)
    if (const HalfEdgeId h(i); mesh_.is_boundary(h)) reach(TriangleMesh::triangle(h), bounds[h]);
  while (!open.empty()) {
    const TriangleId t = open.back();
    open.pop_back();
    for (Index i = 3 * t; i < 3 * t + 3; ++i)
      if (const HalfEdgeId h(i); !mesh_.is_boundary(h))
        reach(TriangleMesh::triangle(mesh_.twin(h)), is_kept_[t] != bounds[h]);
  }
  if (is_empty())
    throw InputError("no triangle is inside the outline; is it of the same coordinate system?");
  return static_cast<std::size_t>(std::count(is_kept_.begin(), is_kept_.end(), false));
}

std::size_t Restrictor::leave_out_too_long(double max_edge) {
  if (std::isinf(max_edge)) return 0;
  const auto is_too_long = [&](HalfEdgeId h) {
    const Point &a = xy_[mesh_.origin(h)], &b = xy_[mesh_.target(h)];
    return !delaunay_.walls[h] && std::hypot(a.x - b.x, a.y - b.y) > max_edge;
  };
  std::vector<TriangleId> open;
  std::size_t count = 0;
  const auto look_at = [&](HalfEdgeId h) {
    const TriangleId t = TriangleMesh::triangle(h);
    if (!is_kept_[t] || !is_at_border(h) || !is_too_long(h)) return;
    is_kept_[t] = false;
    ++count;
    open.push_back(t);
  };
  for (Index i = 0; i < mesh_.halfedge_count(); ++i) look_at(HalfEdgeId(i));
  while (!open.empty()) {
    const TriangleId t = open.back();
    open.pop_back();
    for (Index i = 3 * t; i < 3 * t + 3; ++i)
      if (const HalfEdgeId twin = mesh_.twin(HalfEdgeId(i)); twin.valid()) look_at(twin);
  }
  if (is_empty())
    throw InputError(fmt::format(
        "no triangle is left: all have an edge longer than {} on the way from the boundary",
        max_edge));
  return count;
}

// ---- What is left. ----

/// Sets the fan of each kept half-edge, that is of the corner that it leaves: kept triangles around
/// a vertex that hang together. Returns the vertex of each fan.
std::vector<Index> Restrictor::fans(Buffer<Index>& fan_of) const {
  std::vector<Index> vertex_of;
  for (Index i = 0; i < mesh_.halfedge_count(); ++i) {
    const HalfEdgeId first(i);
    if (!is_kept_[TriangleMesh::triangle(first)] || fan_of[first] != kNone) continue;
    const auto fan = static_cast<Index>(vertex_of.size());
    vertex_of.push_back(mesh_.origin(first));
    HalfEdgeId h = first;
    do {
      fan_of[h] = fan;
      if (is_at_border(TriangleMesh::prev(h))) break;
      h = mesh_.rotate_ccw(h);
    } while (h != first);
    for (h = first; !is_at_border(h);) {
      h = mesh_.rotate_cw(h);
      if (std::exchange(fan_of[h], fan) == fan) break;
    }
  }
  return vertex_of;
}

std::size_t Restrictor::renumber() && {
  Buffer<Index> fan_of(mesh_.halfedge_count(), kNone);
  const std::vector<Index> vertex_of = fans(fan_of);
  std::vector<Index> in_order(vertex_of.size()), number(vertex_of.size());
  for (Index f = 0; f < in_order.size(); ++f) in_order[f] = f;
  std::stable_sort(in_order.begin(), in_order.end(),
                   [&](Index f, Index g) { return vertex_of[f] < vertex_of[g]; });
  std::size_t used = 0;
  for (Index v = 0; v < in_order.size(); ++v) {
    number[in_order[v]] = v;
    used += v == 0 || vertex_of[in_order[v]] != vertex_of[in_order[v - 1]];
  }

  const VertexSet& old = delaunay_.vertices;
  const std::size_t unused = old.size() - used, size = in_order.size();
  VertexSet vertices{Buffer<Point>(size), Buffer<double>(old.z.empty() ? 0 : size),
                     Buffer<Index>(size), old.duplicate_heights};
  for (Index v = 0; v < size; ++v) {
    const Index from = vertex_of[in_order[v]];
    vertices.xy[v] = old.xy[from];
    if (!old.z.empty()) vertices.z[v] = old.z[from];
    vertices.row[v] = old.row[from];
  }

  const auto kept = static_cast<std::size_t>(std::count(is_kept_.begin(), is_kept_.end(), true));
  Buffer<Index> place(mesh_.triangle_count()), origins(3 * kept), twins(3 * kept);
  Buffer<bool> walls(3 * kept);
  Index next = 0;
  for (Index t = 0; t < place.size(); ++t) place[t] = is_kept_[t] ? next++ : kNone;
  for (Index i = 0; i < mesh_.halfedge_count(); ++i) {
    const HalfEdgeId h(i);
    const Index at = place[TriangleMesh::triangle(h)];
    if (at == kNone) continue;
    const HalfEdgeId twin = mesh_.twin(h);
    origins[3 * at + i % 3] = number[fan_of[h]];
    twins[3 * at + i % 3] =
        is_at_border(h) ? kNone : 3 * place[TriangleMesh::triangle(twin)] + twin % 3;
    walls[3 * at + i % 3] = delaunay_.walls[h];
  }
  delaunay_ = {std::move(vertices), TriangleMesh(size, std::move(origins), std::move(twins)),
               std::move(walls)};
  return unused;
}

}  // namespace

Restriction restrict_to_domain(Delaunay& delaunay,
                               std::span<const std::array<VertexId, 2>> boundary, double max_edge) {
  if (boundary.empty() && std::isinf(max_edge)) return {};
  Restrictor restrictor(delaunay);
  Restriction restriction;
  restriction.outside = restrictor.leave_out_outside(boundary);
  restriction.too_long = restrictor.leave_out_too_long(max_edge);
  if (restriction.outside + restriction.too_long > 0)
    restriction.unused = std::move(restrictor).renumber();
  return restriction;
}

}  // namespace hodt
