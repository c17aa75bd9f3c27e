#include "hodt/order/constrained/constrained_delaunay.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

#include "hodt/base/prefetch.h"
#include "hodt/geometry/direction.h"
#include "hodt/geometry/predicates.h"
#include "hodt/mesh/find_outgoing.h"
#include "hodt/order/emptiest.h"

namespace hodt {

namespace {

/// So many edges before its turn an edge is prepared.
constexpr std::size_t kAhead = 8;

/// One side of a segment, while the triangles that it crosses make way.
struct Chain {
  std::vector<VertexId> vertices;     // from the one end to the other, both included
  std::vector<HalfEdgeId> old_sides;  // edge i joins vertices i and i + 1, inside the cavity

  void begin(VertexId v) {
    vertices.assign(1, v);
    old_sides.clear();
  }
  void add(VertexId v, HalfEdgeId side) {
    vertices.push_back(v);
    old_sides.push_back(side);
  }
  void reverse() {
    std::reverse(vertices.begin(), vertices.end());
    std::reverse(old_sides.begin(), old_sides.end());
  }
};

/// A wall, and the edge that it was made for; or a wall that an edge met.
struct Wall {
  Index a, b;
  Index edge;

  Wall(VertexId v, VertexId w, Index e) : a(std::min(v, w)), b(std::max(v, w)), edge(e) {}
  bool operator<(const Wall& other) const { return std::tie(a, b) < std::tie(other.a, other.b); }
};

class Inserter {
 public:
  explicit Inserter(Delaunay& delaunay)
      : xy_(delaunay.vertices.xy),
        mesh_(delaunay.mesh),
        walls_(delaunay.walls),
        outgoing_(outgoing_halfedges(delaunay.mesh)) {}

  void insert(Index edge, VertexId from, VertexId to);
  /// Asks memory for what insert() needs at its first end.
  void prepare(VertexId v) const {
    const HalfEdgeId h = outgoing_[v];
    prefetch(&mesh_.origins()[h]);
    prefetch(&mesh_.twins()[h]);
    prefetch(&walls_[h]);
    prefetch(&xy_[v]);
  }
  /// The pairs of edges, the later of which met a wall of the earlier.
  std::vector<CrossingEdges> crossings() &&;

 private:
  /// Where the way from a vertex towards another one begins: along an edge, given by a half-edge,
  /// or across one.
  struct Start {
    HalfEdgeId along, across;
    bool is_known = false;
  };
  /// Triangles are to fill the chain from one vertex to another, beside a half-edge that runs back
  /// from the last one to the first.
  struct Part {
    Index first, last;
    HalfEdgeId outside;
  };
  /// A side of the cavity, and what lies beyond it.
  struct Side {
    HalfEdgeId old_side, beyond, new_side;
    bool is_wall;
  };

  Start start(VertexId from, VertexId to, Index most) const;
  VertexId insert_piece(const Start& start, VertexId from, VertexId to);
  VertexId make_way(HalfEdgeId crossed, VertexId from, VertexId to);
  void fill_cavity();
  void note_sides(const Chain& chain);
  HalfEdgeId fill(const Chain& chain, HalfEdgeId outside, std::size_t first_side);
  void glue_sides();
  void keep_outgoing_valid(TriangleId t);
  void make_wall(HalfEdgeId h);

  const std::span<const Point> xy_;
  TriangleMesh& mesh_;
  Buffer<bool>& walls_;
  Buffer<HalfEdgeId> outgoing_;
  Index edge_ = 0;  // the one that is being inserted
  std::vector<Wall> made_, met_;

  // Scratch of make_way().
  Chain left_, right_;
  std::vector<TriangleId> cavity_;
  std::size_t cavity_used_ = 0;
  std::vector<Part> parts_;
  std::vector<Side> sides_;
};

// ---- Along the edge, from vertex to vertex. ----

void Inserter::insert(Index edge, VertexId from, VertexId to) {
  if (from == to) return;
  edge_ = edge;
  // From the other end, if very many edges are at this one.
  Start first = start(from, to, kFewTriangles);
  if (!first.is_known) {
    std::swap(from, to);
    first = start(from, to, kFewTriangles);
    if (!first.is_known) first = start(from, to, kNone);
  }
  from = insert_piece(first, from, to);
  while (from != to) from = insert_piece(start(from, to, kNone), from, to);
}

/// Looks at so many triangles around the vertex.
Inserter::Start Inserter::start(VertexId from, VertexId to, Index most) const {
  const Point &a = xy_[from], &b = xy_[to];
  Start start;
  const auto is_start = [&](HalfEdgeId h) {
    const Point &right = xy_[mesh_.target(h)], &left = xy_[mesh_.apex(h)];
    if (is_same_direction(a, b, right)) {
      start.along = h;
      return true;
    }
    // No half-edge leaves a vertex on the boundary along its last edge.
    if (const HalfEdgeId last = TriangleMesh::prev(h);
        mesh_.is_boundary(last) && is_same_direction(a, b, left)) {
      start.along = last;
      return true;
    }
    if (orient(a, right, b) <= 0 || orient(a, b, left) <= 0) return false;
    start.across = TriangleMesh::next(h);
    return true;
  };
  start.is_known = find_outgoing(mesh_, outgoing_[from], most, is_start).is_known;
  return start;
}

/// Inserts the edge as far as the next vertex on it, and returns that.
VertexId Inserter::insert_piece(const Start& start, VertexId from, VertexId to) {
  if (!start.along.valid()) return make_way(start.across, from, to);
  make_wall(start.along);
  const VertexId origin = mesh_.origin(start.along);
  return origin == from ? mesh_.target(start.along) : origin;
}

void Inserter::make_wall(HalfEdgeId h) {
  if (walls_[h]) return;
  walls_[h] = true;
  if (mesh_.twin(h).valid()) walls_[mesh_.twin(h)] = true;
  made_.emplace_back(mesh_.origin(h), mesh_.target(h), edge_);
}

// ---- The triangles that it crosses make way. ----

/// `crossed` is the first edge that the segment crosses. Triangulates both sides of the segment up
/// to the next vertex on it, and returns that. If a wall is in the way, all stays.
VertexId Inserter::make_way(HalfEdgeId crossed, VertexId from, VertexId to) {
  const Point &a = xy_[from], &b = xy_[to];
  bool is_free = true;
  cavity_.assign(1, TriangleMesh::triangle(crossed));
  left_.begin(from);
  left_.add(mesh_.target(crossed), TriangleMesh::next(crossed));
  right_.begin(from);
  right_.add(mesh_.origin(crossed), TriangleMesh::prev(crossed));
  for (HalfEdgeId h = crossed; h.valid();) {
    if (walls_[h]) {
      is_free = false;
      met_.emplace_back(mesh_.origin(h), mesh_.target(h), edge_);
    }
    // `across` runs from left to right; the next half-edge from right to w, the last from w to
    // left.
    const HalfEdgeId across = mesh_.twin(h);
    const HalfEdgeId right_side = TriangleMesh::next(across),
                     left_side = TriangleMesh::prev(across);
    const VertexId w = mesh_.origin(left_side);
    const int side = w == to ? 0 : orient(a, b, xy_[w]);
    cavity_.push_back(TriangleMesh::triangle(across));
    if (side >= 0) left_.add(w, left_side);
    if (side <= 0) right_.add(w, right_side);
    h = side > 0 ? right_side : side < 0 ? left_side : HalfEdgeId();
  }
  const VertexId end = left_.vertices.back();
  if (is_free) fill_cavity();
  return end;
}

void Inserter::fill_cavity() {
  right_.reverse();
  sides_.clear();
  note_sides(left_);
  note_sides(right_);
  cavity_used_ = 0;
  const HalfEdgeId on_left = fill(left_, HalfEdgeId(), 0);
  fill(right_, on_left, left_.old_sides.size());
  glue_sides();
  for (const TriangleId t : cavity_) keep_outgoing_valid(t);
  make_wall(on_left);
}

void Inserter::note_sides(const Chain& chain) {
  for (const HalfEdgeId h : chain.old_sides)
    sides_.push_back({h, mesh_.twin(h), HalfEdgeId(), walls_[h]});
}

/// The paper's greedy triangulation: of the chain's vertices the one that sees the edge from the
/// first to the last under the emptiest circle makes a triangle with it, and so on beside the two
/// other edges. The chain is on the left of that edge, whose other side is `outside`. Returns the
/// new half-edge along it. `first_side` is the chain's first one among the sides.
HalfEdgeId Inserter::fill(const Chain& chain, HalfEdgeId outside, std::size_t first_side) {
  HalfEdgeId along;
  parts_.assign(1, {0, static_cast<Index>(chain.vertices.size() - 1), outside});
  while (!parts_.empty()) {  // not recursion: chains can be long
    const auto [first, last, beyond] = parts_.back();
    parts_.pop_back();
    const VertexId a = chain.vertices[first], b = chain.vertices[last];
    const auto best = static_cast<Index>(emptiest(xy_, chain.vertices, first, last));
    const HalfEdgeId base = TriangleMesh::halfedge(cavity_[cavity_used_++]);
    const HalfEdgeId from_best = TriangleMesh::prev(base), to_best = TriangleMesh::next(base);
    mesh_.set_origin(base, a);
    mesh_.set_origin(to_best, b);
    mesh_.set_origin(from_best, chain.vertices[best]);
    for (const HalfEdgeId h : {base, to_best, from_best}) walls_[h] = false;
    if (!along.valid()) along = base;
    mesh_.glue(base, beyond);
    if (best == first + 1)
      sides_[first_side + first].new_side = from_best;
    else
      parts_.push_back({first, best, from_best});
    if (best + 1 == last)
      sides_[first_side + best].new_side = to_best;
    else
      parts_.push_back({best, last, to_best});
  }
  return along;
}

/// Where an edge that is not crossed ends inside the cavity, two of its sides face each other.
void Inserter::glue_sides() {
  std::sort(sides_.begin(), sides_.end(),
            [](const Side& s, const Side& t) { return s.old_side < t.old_side; });
  for (const Side& side : sides_) {
    const auto facing =
        std::lower_bound(sides_.begin(), sides_.end(), side.beyond,
                         [](const Side& s, HalfEdgeId h) { return s.old_side < h; });
    const bool is_facing = facing != sides_.end() && facing->old_side == side.beyond;
    walls_[side.new_side] = side.is_wall;
    mesh_.glue(side.new_side, is_facing ? facing->new_side : side.beyond);
  }
}

/// Points the corners of a new triangle at it, boundary half-edges first.
void Inserter::keep_outgoing_valid(TriangleId t) {
  for (Index i = 0; i < 3; ++i) {
    const HalfEdgeId h(TriangleMesh::halfedge(t) + i);
    HalfEdgeId& known = outgoing_[mesh_.origin(h)];
    if (mesh_.is_boundary(h) || mesh_.origin(known) != mesh_.origin(h)) known = h;
  }
}

// ---- Edges that cross. ----

std::vector<CrossingEdges> Inserter::crossings() && {
  if (met_.empty()) return {};
  // Of edges that overlap, the one that made the wall.
  std::sort(made_.begin(), made_.end());
  std::vector<CrossingEdges> crossings;
  for (const Wall& wall : met_) {
    const Index other = std::lower_bound(made_.begin(), made_.end(), wall)->edge;
    crossings.push_back({std::min(other, wall.edge), std::max(other, wall.edge)});
  }
  std::sort(crossings.begin(), crossings.end());
  crossings.erase(std::unique(crossings.begin(), crossings.end()), crossings.end());
  return crossings;
}

/// By their first ends, along the curve that the vertices are numbered by: so what is near in the
/// plane is done at about the same time.
std::vector<Wall> along_the_curve(std::span<const std::array<VertexId, 2>> edges) {
  std::vector<Wall> sorted;
  sorted.reserve(edges.size());
  for (Index i = 0; i < edges.size(); ++i) sorted.emplace_back(edges[i][0], edges[i][1], i);
  std::sort(sorted.begin(), sorted.end(), [](const Wall& e, const Wall& f) {
    return std::tie(e.a, e.b, e.edge) < std::tie(f.a, f.b, f.edge);
  });
  return sorted;
}

}  // namespace

std::vector<CrossingEdges> insert_walls(Delaunay& delaunay,
                                        std::span<const std::array<VertexId, 2>> edges) {
  delaunay.walls = Buffer<bool>(delaunay.mesh.halfedge_count(), false);
  Inserter inserter(delaunay);
  const std::vector<Wall> sorted = along_the_curve(edges);
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (i + kAhead < sorted.size()) inserter.prepare(VertexId(sorted[i + kAhead].a));
    inserter.insert(sorted[i].edge, VertexId(sorted[i].a), VertexId(sorted[i].b));
  }
  return std::move(inserter).crossings();
}

}  // namespace hodt
