#include "hodt/optimize/extrema/extrema_triangulation.h"

#include <algorithm>

#include "hodt/optimize/extrema/height_ranks.h"

namespace hodt {

namespace {

/// The bits of the kinds that the objective counts and the question is answered yes for.
template <class IsExtremum>
std::uint8_t bits_of(Objective objective, const IsExtremum& is_extremum) {
  std::uint8_t bits = 0;
  if (counts_minima(objective) && is_extremum(Extremum::minimum)) bits |= bit(Extremum::minimum);
  if (counts_maxima(objective) && is_extremum(Extremum::maximum)) bits |= bit(Extremum::maximum);
  return bits;
}

/// Walks around v until a neighbour is found that keeps it from being one.
bool is_extremum_in(const ConstrainedTriangulation& triangulation, const Heights& heights,
                    VertexId v, Extremum kind) {
  const TriangleMesh& mesh = triangulation.mesh();
  HalfEdgeId h = triangulation.outgoing(v);
  const HalfEdgeId start = h;
  for (;;) {
    if (heights.removes(mesh.target(h), v, kind)) return false;
    const HalfEdgeId following = mesh.rotate_ccw(h);
    if (following == start) return true;
    if (!following.valid()) return !heights.removes(mesh.apex(h), v, kind);
    h = following;
  }
}

/// Of a set of kinds. (A call of the library's popcount takes longer than all else here.)
int size_of(std::uint8_t kinds) {
  return (kinds & 1) + (kinds >> 1);
}

}  // namespace

Buffer<std::uint8_t> extrema_of(const TriangleMesh& mesh, const Heights& heights,
                                Objective objective) {
  const Buffer<HeightRanks> ranks = height_ranks_of(mesh, heights);
  Buffer<std::uint8_t> extrema(ranks.size());
  for (Index v = 0; v < extrema.size(); ++v)
    extrema[v] = bits_of(objective, [&](Extremum kind) { return ranks[v].is_extremum(kind); });
  return extrema;
}

std::size_t count_extrema(std::span<const std::uint8_t> extrema) {
  std::size_t count = 0;
  for (const std::uint8_t bits : extrema) count += std::size_t(size_of(bits));
  return count;
}

Buffer<bool> kept_minima(std::span<const std::uint8_t> extrema, std::span<const bool> keep) {
  Buffer<bool> kept(extrema.size(), false);
  for (std::size_t v = 0; v < keep.size(); ++v)
    kept[v] = keep[v] && (extrema[v] & bit(Extremum::minimum)) != 0;
  return kept;
}

ExtremaTriangulation::ExtremaTriangulation(const DelaunayGraph& graph, const Heights& heights,
                                           Objective objective, std::span<const bool> keep)
    : heights_(heights),
      objective_(objective),
      triangulation_(graph),
      extrema_(extrema_of(graph.mesh, heights, objective)),
      kept_(kept_minima(extrema_, keep)) {}

bool ExtremaTriangulation::keeps_all() const {
  for (Index v = 0; v < kept_.size(); ++v)
    if (kept_[v] && !is_extremum(VertexId(v), Extremum::minimum)) return false;
  return true;
}

void ExtremaTriangulation::lock_if_better(VertexId owner, VertexId to) {
  const auto before = triangulation_.now();
  if (triangulation_.lock(owner, to) && triangulation_.last_hull_was_original() &&
      is_better(before)) {
    for (const VertexId v : corners_) extrema_[v] = extrema_at(v);
    triangulation_.commit();
  } else {
    triangulation_.roll_back(before);
  }
}

/// Net, because a vertex can lose its only lower neighbour to an edge that helps another.
bool ExtremaTriangulation::is_better(ConstrainedTriangulation::Moment since) {
  find_changed_corners(since);
  int gained = 0;
  for (const VertexId v : corners_) {
    const std::uint8_t now = extrema_at(v);
    if (kept_[v] && (extrema_[v] & ~now & bit(Extremum::minimum))) return false;
    gained += size_of(extrema_[v]) - size_of(now);
  }
  return gained > 0;
}

void ExtremaTriangulation::find_changed_corners(ConstrainedTriangulation::Moment since) {
  triangulation_.changed_since(since, changed_);
  corners_.clear();
  for (const TriangleId t : changed_)
    for (const VertexId v : triangulation_.mesh().corners(t)) corners_.push_back(v);
  std::sort(corners_.begin(), corners_.end());
  corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
}

std::uint8_t ExtremaTriangulation::extrema_at(VertexId v) const {
  return bits_of(objective_,
                 [&](Extremum kind) { return is_extremum_in(triangulation_, heights_, v, kind); });
}

Buffer<Index> ExtremaTriangulation::partners() const {
  Buffer<Index> partners(extrema_.size());
  for (Index v = 0; v < partners.size(); ++v) partners[v] = triangulation_.partner(VertexId(v));
  return partners;
}

void ExtremaTriangulation::hold(const Buffer<Index>& partners, const Deadline& deadline) {
  edit([&](ConstrainedTriangulation& triangulation) {
    for (Index v = 0; v < partners.size(); ++v)
      if (const VertexId u(v);
          triangulation.owns_locked_edge(u) && triangulation.partner(u) != partners[v]) {
        deadline.check();
        triangulation.release(u);
      }
    for (Index v = 0; v < partners.size(); ++v)
      if (const VertexId u(v); partners[v] != kNone && !triangulation.owns_locked_edge(u)) {
        deadline.check();
        triangulation.lock(u, VertexId(partners[v]));
      }
  });
}

}  // namespace hodt
