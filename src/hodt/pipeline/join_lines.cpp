#include "hodt/pipeline/join_lines.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/delaunay/delaunay.h"
#include "hodt/geometry/predicates.h"
#include "hodt/hydrology/nearest_points.h"
#include "hodt/pipeline/constrain.h"
#include "hodt/tin/interpolate.h"

namespace hodt {

namespace {

struct HashOfPoint {
  std::size_t operator()(const Point& p) const {
    // -0 is 0.
    const auto x = std::bit_cast<std::uint64_t>(p.x + 0.0),
               y = std::bit_cast<std::uint64_t>(p.y + 0.0);
    const std::uint64_t mixed = (x ^ std::rotl(y, 32)) * 0x9e3779b97f4a7c15u;
    return static_cast<std::size_t>(mixed ^ (mixed >> 29));
  }
};

/// What stands at a place where a line has a vertex.
struct Place {
  Index row = kNone;
  bool was_point = false;
  bool has_line_height = false;
};

Index as_index(std::size_t number) {
  return static_cast<Index>(number);
}

/// Of points on one line.
bool is_between(const Point& a, const Point& p, const Point& b) {
  return lexicographically_less(a, b)
             ? lexicographically_less(a, p) && lexicographically_less(p, b)
             : lexicographically_less(b, p) && lexicographically_less(p, a);
}

void note(std::size_t& count, double& largest, double difference) {
  if (difference == 0) return;
  ++count;
  largest = std::max(largest, std::fabs(difference));
}

struct Box {
  Point low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point high{-low.x, -low.y};

  void add(const Point& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  bool meets(const Box& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y &&
           other.low.y <= high.y;
  }
};

/// Lines that are all beside the points are of another coordinate system.
void check_place(const PointSet& points, const Lines& source) {
  Box around, lines;
  for (const Point& p : points.xy) around.add(p);
  for (const Line& line : source.lines)
    for (const Point& p : line.xy) lines.add(p);
  if (!points.xy.empty() && !source.lines.empty() && !around.meets(lines))
    throw InputError(
        fmt::format("{}: its lines, with x from {} to {} and y from {} to {}, are nowhere near the "
                    "points, with "
                    "x from {} to {} and y from {} to {}; are they of the same coordinate system?",
                    source.source, lines.low.x, lines.high.x, lines.low.y, lines.high.y,
                    around.low.x, around.high.x, around.low.y, around.high.y));
}

class Joiner {
 public:
  Joiner(const PointSet& points, const JoinOptions& options) : options_(options) {
    joined_.points = points;
  }

  Joined join(std::span<const Lines> lines, const std::optional<Outline>& outline) &&;

 private:
  void snap_to_points();
  void find_points();
  void take_vertices(bool with_heights);
  using Pieces = std::vector<std::array<Index, 2>>;
  void look_along_lines(const Delaunay& d, const Buffer<VertexId>& vertex_of, const Pieces& pieces);
  void take_heights_of_surface(const Tin& surface);
  void bring_heights_together();
  Pieces pieces_with_heights() const;
  bool is_hard(Index edge) const {  // one with heights
    const auto [s, l, i] = joined_.origins[edge];
    return joined_.sources[s].lines[l].has_heights();
  }
  void add_edges();
  void split_crossings();
  bool split_crossings_once(std::unordered_map<Point, Index, HashOfPoint>& rows);
  Index vertex_at_crossing(const CrossingEdges& crossing,
                           std::unordered_map<Point, Index, HashOfPoint>& rows);
  double height_between(Index a, Index b, const Point& p) const;
  double height_on(Index number, const Point& p) const {
    const auto& [a, b] = edge(number);
    return height_between(a, b, p);
  }
  const Constraints::Edge& edge(Index number) const {
    const Constraints& c = joined_.constraints;
    return number < c.edges.size() ? c.edges[number] : c.boundary[number - c.edges.size()];
  }
  bool has_heights() const { return joined_.points.has_heights(); }
  template <class F>
  void for_each_line(const F& f) const {
    for (const Lines& source : joined_.sources)
      for (const Line& line : source.lines) f(source, line);
  }

  const JoinOptions& options_;
  bool has_outline_ = false;  // then it is the last source
  Joined joined_;
  std::unordered_map<Point, Place, HashOfPoint> places_;
  std::vector<Index> soft_;  // rows that have no height yet
};

Joined Joiner::join(std::span<const Lines> lines, const std::optional<Outline>& outline) && {
  joined_.sources.assign(lines.begin(), lines.end());
  has_outline_ = outline.has_value();
  if (outline)
    joined_.sources.push_back(
        {outline->rings, outline->source, outline->part, outline->crs, outline->warnings});
  for (const Lines& source : joined_.sources) check_place(joined_.points, source);
  if (options_.snap > 0) snap_to_points();
  find_points();
  take_vertices(true);
  take_vertices(false);
  bring_heights_together();
  add_edges();
  if (options_.split_crossings) split_crossings();
  return std::move(joined_);
}

void Joiner::snap_to_points() {
  // Near in the plane, near in number: so by the vertices of a triangulation.
  const Delaunay d = delaunay({joined_.points.xy, {}});
  std::vector<Point> vertices;
  for_each_line([&](const Lines&, const Line& line) {
    vertices.insert(vertices.end(), line.xy.begin(), line.xy.end());
  });
  const std::vector<VertexId> nearest = nearest_points(d.vertices.xy, vertices);
  std::size_t next = 0;
  for (Lines& source : joined_.sources)
    for (Line& line : source.lines) {
      const bool is_ring = line.xy.size() > 1 && line.is_closed();
      const std::vector<Point> before = line.xy;
      for (Point& p : line.xy) {
        const Point& q = d.vertices.xy[nearest[next++]];
        if (p == q || std::hypot(p.x - q.x, p.y - q.y) > options_.snap) continue;
        p = q;
        // A ring's last vertex is its first one.
        joined_.report.snapped += !is_ring || &p != &line.xy.back();
      }
      for (std::size_t i = 0; i + 1 < before.size(); ++i)
        joined_.report.collapsed += before[i] != before[i + 1] && line.xy[i] == line.xy[i + 1];
    }
}

/// Which places of lines have points.
void Joiner::find_points() {
  for_each_line([&](const Lines&, const Line& line) {
    for (const Point& p : line.xy) places_.try_emplace(p);
  });
  if (places_.empty()) return;
  const std::vector<Point>& xy = joined_.points.xy;
  for (std::size_t row = 0; row < xy.size(); ++row) {
    const auto place = places_.find(xy[row]);
    if (place == places_.end()) continue;
    // Of points at the same place the lowest is the one that stays.
    const std::vector<double>& z = joined_.points.z;
    Place& at = place->second;
    if (!at.was_point || (has_heights() && z[row] < z[at.row])) at.row = as_index(row);
    at.was_point = true;
  }
}

/// Of lines with heights, or of those without.
void Joiner::take_vertices(bool with_heights) {
  PointSet& points = joined_.points;
  JoinReport& report = joined_.report;
  for_each_line([&](const Lines&, const Line& line) {
    if (line.has_heights() != with_heights) return;
    // A ring's last vertex is its first one, unless it comes back at another height.
    const bool is_ring = line.xy.size() > 1 && line.is_closed() &&
                         (!with_heights || line.z.front() == line.z.back());
    const std::size_t size = line.xy.size() - is_ring;
    for (std::size_t i = 0; i < size; ++i) {
      Place& at = places_.at(line.xy[i]);
      const bool gives_height = with_heights && has_heights();
      if (at.row == kNone) {
        at.row = as_index(points.size());
        points.xy.push_back(line.xy[i]);
        if (has_heights()) points.z.push_back(gives_height ? line.z[i] : 0);
        if (has_heights() && !gives_height) soft_.push_back(at.row);
        ++report.added;
      } else {
        report.at_points += at.was_point;
        if (gives_height && at.has_line_height) {
          note(report.heights_in_conflict, report.largest_conflict, line.z[i] - points.z[at.row]);
        } else if (gives_height) {
          note(report.heights_replaced, report.largest_replacement, line.z[i] - points.z[at.row]);
          points.z[at.row] = line.z[i];
        }
      }
      at.has_line_height |= gives_height;
    }
  });
  if (!with_heights) return;
  // All points there get the line's height: which of them stays must make no difference.
  const std::size_t size = points.z.size();
  for (std::size_t row = 0; row < size; ++row)
    if (const auto place = places_.find(points.xy[row]);
        place != places_.end() && place->second.has_line_height)
      points.z[row] = points.z[place->second.row];
}

/// What lines with heights say of the points they pass through, and of vertices that have none.
void Joiner::bring_heights_together() {
  const Pieces pieces = pieces_with_heights();
  if (!has_heights() || (pieces.empty() && soft_.empty())) return;
  const std::size_t size = soft_.empty() ? joined_.points.size() : soft_.front();
  Tin surface;
  surface.points.xy.assign(joined_.points.xy.begin(),
                           joined_.points.xy.begin() + std::ptrdiff_t(size));
  surface.points.z.assign(joined_.points.z.begin(),
                          joined_.points.z.begin() + std::ptrdiff_t(size));
  surface.triangles.assign(options_.surface.begin(), options_.surface.end());
  if (!pieces.empty() || surface.triangles.empty()) {
    Delaunay d = delaunay(surface.points);
    const Buffer<VertexId> vertex_of = vertices_of_rows(surface.points, d.vertices);
    std::vector<std::array<VertexId, 2>> walls;
    walls.reserve(pieces.size());
    for (const auto& [a, b] : pieces) walls.push_back({vertex_of[a], vertex_of[b]});
    // Where they cross each other some are left out.
    insert_walls(d, walls);
    look_along_lines(d, vertex_of, pieces);
    if (surface.triangles.empty() && !soft_.empty()) {
      const TriangleMesh mesh = in_input_numbering(d.mesh, d.vertices, size);
      surface.triangles.reserve(mesh.triangle_count());
      for (Index t = 0; t < mesh.triangle_count(); ++t) {
        const auto [a, b, c] = mesh.corners(TriangleId(t));
        surface.triangles.push_back({a, b, c});
      }
    }
  }
  if (!soft_.empty()) take_heights_of_surface(surface);
}

/// From vertex to vertex along each piece of a line with heights.
void Joiner::look_along_lines(const Delaunay& d, const Buffer<VertexId>& vertex_of,
                              const Pieces& pieces) {
  const std::span<const Point> xy = d.vertices.xy;
  const Buffer<HalfEdgeId> outgoing = outgoing_halfedges(d.mesh);
  const auto next_on = [&](VertexId from, VertexId to) {
    VertexId next = to;
    const auto look = [&](VertexId w) {
      if (w != from && orient(xy[from], xy[to], xy[w]) == 0 && is_between(xy[from], xy[w], xy[to]))
        next = w;
    };
    for_each_neighbour(d.mesh, outgoing[from], look);
    return next;
  };
  for (const auto& [a, b] : pieces) {
    const VertexId end = vertex_of[b];
    for (VertexId v = vertex_of[a]; v != end;) {
      v = next_on(v, end);
      if (v == end) break;
      const double line = height_between(a, b, xy[v]), difference = d.vertices.z[v] - line;
      const double rounding =
          1e-12 * (std::fabs(joined_.points.z[a]) + std::fabs(joined_.points.z[b]));
      if (std::fabs(difference) > rounding)
        note(joined_.report.heights_passed, joined_.report.largest_passed, difference);
    }
  }
}

void Joiner::take_heights_of_surface(const Tin& surface) {
  PointSet& points = joined_.points;
  const std::size_t first = soft_.front();
  joined_.report.soft = soft_.size();
  const std::vector<double> heights = interpolate(surface, std::span(points.xy).subspan(first));
  std::copy(heights.begin(), heights.end(), points.z.begin() + std::ptrdiff_t(first));
  for_each_line([&](const Lines& source, const Line& line) {
    for (const Point& p : line.xy)
      if (const Index row = places_.at(p).row; std::isnan(points.z[row]))
        throw InputError(fmt::format(
            "{}, {} {}: its vertex at x {}, y {} has no height, and is outside the points, where "
            "there is none to take; give the line heights, or end it within the points",
            source.source, source.part, line.part, p.x, p.y));
  });
}

/// By their rows.
Joiner::Pieces Joiner::pieces_with_heights() const {
  Pieces pieces;
  for_each_line([&](const Lines&, const Line& line) {
    if (!line.has_heights()) return;
    for (std::size_t i = 0; i + 1 < line.xy.size(); ++i)
      pieces.push_back({places_.at(line.xy[i]).row, places_.at(line.xy[i + 1]).row});
  });
  return pieces;
}

void Joiner::add_edges() {
  for (Index s = 0; s < joined_.sources.size(); ++s) {
    const bool is_outline = has_outline_ && s + 1 == joined_.sources.size();
    std::vector<Constraints::Edge>& edges =
        is_outline ? joined_.constraints.boundary : joined_.constraints.edges;
    const std::vector<Line>& lines = joined_.sources[s].lines;
    for (Index l = 0; l < lines.size(); ++l)
      for (Index i = 0; i + 1 < lines[l].xy.size(); ++i) {
        edges.push_back({places_.at(lines[l].xy[i]).row, places_.at(lines[l].xy[i + 1]).row});
        joined_.origins.push_back({s, l, i});
      }
  }
}

// ---- Lines that cross. ----

void Joiner::split_crossings() {
  // Rounding moves the pieces a little, so that they can cross others: hardly ever, and not for
  // long.
  constexpr int kMostRounds = 100;
  constexpr std::size_t kSome = 1000;
  std::unordered_map<Point, Index, HashOfPoint> rows;
  std::size_t most = 0;
  for (int round = 0; round < kMostRounds; ++round) {
    if (!split_crossings_once(rows)) return;
    const std::size_t added = joined_.report.crossings;
    if (round == 0) most = 2 * added + kSome;
    // Of lines along each other the pieces cross more and more.
    if (added > most) break;
  }
  throw InputError(fmt::format(
      "after {} vertices were added where lines cross, lines still cross: these lines run along "
      "each other within the rounding of their coordinates; leave one out, or give them the same "
      "vertices there",
      joined_.report.crossings));
}

/// The height of a piece between these rows there.
double Joiner::height_between(Index a, Index b, const Point& p) const {
  const PointSet& points = joined_.points;
  const Point &from = points.xy[a], &to = points.xy[b];
  const double dx = to.x - from.x, dy = to.y - from.y;
  const double part = std::fabs(dx) > std::fabs(dy) ? (p.x - from.x) / dx : (p.y - from.y) / dy;
  return points.z[a] + std::clamp(part, 0.0, 1.0) * (points.z[b] - points.z[a]);
}

/// The row of a vertex where two edges cross: a new one, unless a point is at that very place.
Index Joiner::vertex_at_crossing(const CrossingEdges& crossing,
                                 std::unordered_map<Point, Index, HashOfPoint>& rows) {
  PointSet& points = joined_.points;
  const auto& [a, b] = edge(crossing.first);
  const auto& [c, d] = edge(crossing.second);
  const Point p = crossing_place(points.xy[a], points.xy[b], points.xy[c], points.xy[d]);
  const auto [at, is_new] = rows.try_emplace(p, as_index(points.size()));
  JoinReport& report = joined_.report;
  if (has_heights()) {
    // What was measured comes before what was taken from the surface.
    const bool is_other = !is_hard(crossing.first) && is_hard(crossing.second);
    const double height = height_on(crossing.first, p), other = height_on(crossing.second, p);
    report.largest_crossing_difference =
        std::max(report.largest_crossing_difference, std::fabs(height - other));
    if (is_new) points.z.push_back(is_other ? other : height);
  }
  if (!is_new) return at->second;
  ++report.crossings;
  points.xy.push_back(p);
  return at->second;
}

bool Joiner::split_crossings_once(std::unordered_map<Point, Index, HashOfPoint>& rows) {
  Constraints& constraints = joined_.constraints;
  PointSet& points = joined_.points;
  Delaunay d = delaunay({points.xy, {}});
  const Buffer<VertexId> vertex_of = vertices_of_rows(points, d.vertices);
  const Index breaklines = as_index(constraints.edges.size());
  const Index count = breaklines + as_index(constraints.boundary.size());
  std::vector<std::array<VertexId, 2>> ends;
  for (Index e = 0; e < count; ++e) ends.push_back({vertex_of[edge(e)[0]], vertex_of[edge(e)[1]]});
  const std::vector<CrossingEdges> crossings = insert_walls(d, ends);
  if (crossings.empty()) return false;
  if (rows.empty())
    for (std::size_t row = 0; row < points.size(); ++row)
      rows.try_emplace(points.xy[row], as_index(row));

  std::vector<std::vector<Index>> on(count);  // the vertices to come on each edge
  for (const CrossingEdges& crossing : crossings) {
    const Index row = vertex_at_crossing(crossing, rows);
    on[crossing.first].push_back(row);
    on[crossing.second].push_back(row);
  }
  Constraints split;
  split.max_edge = constraints.max_edge;
  std::vector<Joined::Origin> origins;
  for (Index e = 0; e < count; ++e) {
    const auto [a, b] = edge(e);
    const Point &from = points.xy[a], &to = points.xy[b];
    // By the coordinate that changes most: products of small differences would all be 0.
    const double dx = to.x - from.x, dy = to.y - from.y;
    const bool by_x = std::fabs(dx) > std::fabs(dy), is_upward = (by_x ? dx : dy) > 0;
    std::stable_sort(on[e].begin(), on[e].end(), [&](Index p, Index q) {
      if (!is_upward) std::swap(p, q);
      return by_x ? points.xy[p].x < points.xy[q].x : points.xy[p].y < points.xy[q].y;
    });
    on[e].push_back(b);
    Index last = a;
    for (const Index next : on[e]) {
      (e < breaklines ? split.edges : split.boundary).push_back({last, next});
      origins.push_back(joined_.origins[e]);
      last = next;
    }
  }
  constraints = std::move(split);
  joined_.origins = std::move(origins);
  return true;
}

}  // namespace

std::string Joined::place_of(Index edge) const {
  const auto [s, l, i] = origins[edge];
  const Lines& source = sources[s];
  const Point &a = source.lines[l].xy[i], &b = source.lines[l].xy[i + 1];
  return fmt::format("{}, {} {}, between x {}, y {} and x {}, y {}", source.source, source.part,
                     source.lines[l].part, a.x, a.y, b.x, b.y);
}

Joined join_lines(const PointSet& points, std::span<const Lines> lines,
                  const std::optional<Outline>& outline, const JoinOptions& options) {
  return Joiner(points, options).join(lines, outline);
}

std::string crossing_text(const Joined& joined, const CrossingEdges& crossing) {
  const Constraints& c = joined.constraints;
  const auto edge = [&](Index e) {
    return e < c.edges.size() ? c.edges[e] : c.boundary[e - c.edges.size()];
  };
  const auto& xy = joined.points.xy;
  const auto [a, b] = edge(crossing.first);
  const auto [p, q] = edge(crossing.second);
  const Point place = crossing_place(xy[a], xy[b], xy[p], xy[q]);
  return fmt::format("lines cross near x {}, y {}: that of {}, and that of {}", place.x, place.y,
                     joined.place_of(crossing.first), joined.place_of(crossing.second));
}

}  // namespace hodt
