#include "hodt/order/voronoi/voronoi_refinement.h"

#include <algorithm>
#include <numeric>

#include "hodt/base/stop.h"

namespace hodt {

namespace {

Index next_of(Index h) {
  return TriangleMesh::next(HalfEdgeId(h));
}
Index prev_of(Index h) {
  return TriangleMesh::prev(HalfEdgeId(h));
}

/// q is on the line through a and b: is it between them?
bool is_between(const Point& a, const Point& b, const Point& q) {
  return lexicographically_less(a, b)
             ? lexicographically_less(a, q) && lexicographically_less(q, b)
             : lexicographically_less(b, q) && lexicographically_less(q, a);
}

}  // namespace

VoronoiRefinement::VoronoiRefinement(std::span<const Point> xy, const VoronoiDiagram& coarse)
    : xy_(xy),
      coarse_(coarse),
      first_new_(coarse.old_vertices),
      old_(static_cast<Index>(coarse.dual.triangle_count()) - coarse.old_vertices),
      outgoing_(outgoing_halfedges(coarse.dual)),
      twin_(std::size_t{3} * old_, kNone),
      site_(coarse.sites.begin() + std::size_t{3} * first_new_, coarse.sites.end()) {}

VoronoiDiagram VoronoiRefinement::run() {
  for (Index cell = 0; cell < coarse_.cell_count(); ++cell) {
    check_stop();
    gather_ring(cell);
    triangulate_ring(cell);
  }
  return assemble();
}

// Along the boundary of a cell, the nearest of the others changes at new vertices only. At corner i
// of such a vertex it changes from site i + 1 to site i + 2; the old vertex that it becomes has its
// edge on their bisector inside this cell.
void VoronoiRefinement::gather_ring(Index cell) {
  ring_.clear();
  const HalfEdgeId first = outgoing_[cell];
  const bool unbounded = coarse_.dual.is_boundary(first);
  if (unbounded) ring_.push_back({VertexId(), HalfEdgeId()});
  HalfEdgeId last;
  for_each_outgoing(coarse_.dual, first, [&](HalfEdgeId h) {
    last = h;
    if (!coarse_.is_new(TriangleMesh::triangle(h))) return;
    const HalfEdgeId opposite = TriangleMesh::next(h);
    ring_.push_back({coarse_.sites[opposite], HalfEdgeId(opposite - 3 * first_new_)});
  });
  if (unbounded) ring_.push_back({coarse_.leaving(TriangleMesh::prev(last)), HalfEdgeId()});
}

void VoronoiRefinement::glue(Index a, Index b) {
  if (a != kNone) twin_[a] = b;
  if (b != kNone) twin_[b] = a;
}

// Chew's algorithm: corners are taken away in random order and put back in the opposite order, each
// between two that are neighbours then. That takes expected time linear in the corners.
void VoronoiRefinement::triangulate_ring(Index cell) {
  const auto corners = static_cast<Index>(ring_.size());
  if (corners < 2) return;
  if (corners == 2) return glue(ring_[0].leaf, ring_[1].leaf);
  const auto first = static_cast<Index>(twin_.size() / 3);
  choose_insertion_order();
  const Index a = 0, b = next_[a], c = next_[b];
  add_triangle(a, b, c);
  for (Index i = 0; i < 3; ++i) side_[site_[3 * first + i]] = 3 * first + i;
  while (!removed_.empty()) {
    insert(removed_.back());
    removed_.pop_back();
  }
  for (Index i = 0; i < corners; ++i) glue(side_[i], ring_[i].leaf);
  if (is_infinite(0)) drop_infinite_triangles(first);
  for (std::size_t h = std::size_t{3} * first; h < site_.size(); ++h)
    site_[h] = ring_[site_[h]].site;
  cell_.resize(site_.size() / 3 - old_, cell);
}

void VoronoiRefinement::choose_insertion_order() {
  const auto corners = static_cast<Index>(ring_.size());
  next_.resize(corners);
  prev_.resize(corners);
  side_.resize(corners);
  for (Index i = 0; i < corners; ++i) {
    next_[i] = i + 1 == corners ? 0 : i + 1;
    prev_[i] = i == 0 ? corners - 1 : i - 1;
  }
  removed_.resize(corners - 1);  // corner 0 stays: it may be infinity
  std::iota(removed_.begin(), removed_.end(), Index{1});
  constexpr Index no_matter = 8;
  if (corners > no_matter) {
    std::uint64_t state = corners;
    for (Index i = corners - 1; i > 1; --i) {
      state = state * 6364136223846793005u + 1442695040888963407u;
      std::swap(removed_[i - 1], removed_[(state >> 33) % i]);
    }
  }
  removed_.resize(corners - 3);
  for (const Index i : removed_) {
    next_[prev_[i]] = next_[i];
    prev_[next_[i]] = prev_[i];
  }
}

void VoronoiRefinement::add_triangle(Index a, Index b, Index c) {
  for (const Index corner : {a, b, c}) {
    site_.push_back(corner);
    twin_.push_back(kNone);
  }
}

void VoronoiRefinement::insert(Index corner) {
  const Index left = prev_[corner], right = next_[corner];
  next_[left] = prev_[right] = corner;
  const auto h = static_cast<Index>(twin_.size());
  const Index inner = side_[left];
  add_triangle(left, corner, right);
  glue(h + 2, inner);
  side_[left] = h;
  side_[corner] = h + 1;
  legalise(HalfEdgeId(h + 2));
}

/// Lawson's flips around the corner opposite to h, which is new. Only triangles without it are
/// asked about: they are those of a diagram, so they turn left.
void VoronoiRefinement::legalise(HalfEdgeId start) {
  pending_.assign(1, start);
  while (!pending_.empty()) {
    const HalfEdgeId h(pending_.back());
    pending_.pop_back();
    const Index g = twin_[h];
    if (g == kNone || !conflicts(HalfEdgeId(g), site_[prev_of(h)])) continue;
    flip(h);
    pending_.push_back(prev_of(g));
    pending_.push_back(h);
  }
}

/// As TriangleMesh::flip, but sides of the polygon may move.
void VoronoiRefinement::flip(HalfEdgeId h) {
  const HalfEdgeId g(twin_[h]);
  const Index hn = next_of(h), gn = next_of(g);
  const Index outside_bc = twin_[hn], outside_ad = twin_[gn];
  site_[hn] = site_[prev_of(g)];
  site_[gn] = site_[prev_of(h)];
  set_outer_twin(h, outside_ad);
  set_outer_twin(g, outside_bc);
  glue(hn, gn);
}

void VoronoiRefinement::set_outer_twin(HalfEdgeId h, Index twin) {
  glue(h, twin);
  if (twin == kNone) side_[site_[h]] = h;
}

/// Whether the corner is nearer than the three of h's triangle to the vertex that they make. With
/// infinity among them that is the end of an unbounded edge, the limit of circles a half-plane.
bool VoronoiRefinement::conflicts(HalfEdgeId h, Index corner) const {
  Index a = site_[h], b = site_[next_of(h)], c = site_[prev_of(h)];
  if (is_infinite(a)) std::swap(a, b), std::swap(b, c);
  if (is_infinite(b)) std::swap(b, a), std::swap(a, c);
  const Point &pa = point(a), &pb = point(b), &q = point(corner);
  if (!is_infinite(c)) return in_circle(pa, pb, point(c), q);
  const int side = orient(pa, pb, q);
  return side > 0 || (side == 0 && is_between(pa, pb, q));
}

/// An edge of the diagram that ends in one goes to infinity: it has no twin.
void VoronoiRefinement::drop_infinite_triangles(Index first) {
  for (auto t = static_cast<Index>(twin_.size() / 3); t-- > first;) {
    const auto begin = site_.begin() + std::ptrdiff_t{3} * t;
    if (std::none_of(begin, begin + 3, [&](Index corner) { return is_infinite(corner); })) continue;
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
      if (twin_[h] != kNone) twin_[twin_[h]] = kNone;
    remove_last_into(t);
  }
}

void VoronoiRefinement::remove_last_into(Index triangle) {
  const auto last = static_cast<Index>(twin_.size() / 3 - 1);
  if (triangle != last) {
    for (Index i = 0; i < 3; ++i) {
      site_[3 * triangle + i] = site_[3 * last + i];
      glue(3 * triangle + i, twin_[3 * last + i]);
    }
  }
  site_.resize(std::size_t{3} * last);
  twin_.resize(std::size_t{3} * last);
}

VoronoiDiagram VoronoiRefinement::assemble() const {
  VoronoiDiagram fine;
  fine.order = coarse_.order + 1;
  fine.old_vertices = old_;
  fine.sites = Buffer<VertexId>(site_.size());
  for (std::size_t h = 0; h < site_.size(); ++h) fine.sites[h] = VertexId(site_[h]);
  Buffer<Index> twins(twin_.size());
  std::copy(twin_.begin(), twin_.end(), twins.begin());
  fine.dual = TriangleMesh(0, Buffer<Index>(twin_.size(), kNone), std::move(twins));
  number_cells(fine);
  return fine;
}

void VoronoiRefinement::number_cells(VoronoiDiagram& fine) const {
  TriangleMesh& dual = fine.dual;
  std::vector<VertexId> members;
  Index cells = 0;
  for (Index i = 0; i < dual.halfedge_count(); ++i) {
    const HalfEdgeId first(i);
    if (dual.origin(first).valid()) continue;
    check_stop();
    const VertexId cell(cells++);
    append_members(first, members);
    HalfEdgeId h = first;
    do {
      dual.set_origin(h, cell);
      h = dual.rotate_ccw(h);
    } while (h.valid() && h != first);
    if (h.valid()) continue;
    for (h = dual.rotate_cw(first); h.valid(); h = dual.rotate_cw(h)) dual.set_origin(h, cell);
  }
  dual.set_vertex_count(cells);
  fine.members = Buffer<VertexId>(members.size());
  std::copy(members.begin(), members.end(), fine.members.begin());
}

/// The members of the cell at the origin of h: those of a coarse cell, and one more.
void VoronoiRefinement::append_members(HalfEdgeId h, std::vector<VertexId>& members) const {
  const Index t = TriangleMesh::triangle(h);
  // At an old vertex: I + the sites at the other two corners; the coarse cell there is I + one.
  const Index next = next_of(h);
  const VertexId added(t < old_ ? site_[next_of(next)] : site_[h]);
  const Index from =
      t < old_ ? Index{coarse_.dual.origin(HalfEdgeId(next + 3 * first_new_))} : cell_[t - old_];
  const std::span<const VertexId> inherited = coarse_.members_of(from);
  const auto place = std::lower_bound(inherited.begin(), inherited.end(), added);
  members.insert(members.end(), inherited.begin(), place);
  members.push_back(added);
  members.insert(members.end(), place, inherited.end());
}

}  // namespace hodt
