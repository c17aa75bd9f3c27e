#include "hodt/order/voronoi/voronoi_polygons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "hodt/base/error.h"

namespace hodt {

namespace {

constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

Point minus(const Point& a, const Point& b) {
  return {a.x - b.x, a.y - b.y};
}
double squared(const Point& a) {
  return a.x * a.x + a.y * a.y;
}
Point clockwise(const Point& a) {
  return {a.y, -a.x};
}

/// a b - c d with a relative error of two rounding units, however close the products are (Kahan).
double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}
double cross(const Point& a, const Point& b) {
  return difference_of_products(a.x, b.y, a.y, b.x);
}

double twice_area(const Point& p, const Point& q, const Point& r) {
  return cross(minus(q, p), minus(r, p));
}

/// 2^e such that the value divided by it is about 1; for use with ldexp.
int exponent_of(double value) {
  return value > 0 ? std::ilogb(value) : 0;
}

/// The centre of the circle through p, q and r; not finite if they seem to be on a line. It is
/// computed from p: if that is opposite the longest side, the error is a few rounding units of the
/// radius.
Point centre(const Point& p, const Point& q, const Point& r) {
  const Point b0 = minus(q, p), c0 = minus(r, p);
  const int e =
      exponent_of(std::max({std::fabs(b0.x), std::fabs(b0.y), std::fabs(c0.x), std::fabs(c0.y)}));
  const Point b{std::ldexp(b0.x, -e), std::ldexp(b0.y, -e)};
  const Point c{std::ldexp(c0.x, -e), std::ldexp(c0.y, -e)};
  const double bb = squared(b), cc = squared(c), area = 2 * cross(b, c);
  const double x = difference_of_products(c.y, bb, b.y, cc) / area;
  const double y = difference_of_products(b.x, cc, c.x, bb) / area;
  return {p.x + std::ldexp(x, e), p.y + std::ldexp(y, e)};
}

/// Calls f with the three points rotated so that the first is opposite the longest side.
template <class F>
auto from_best_corner(const Point& a, const Point& b, const Point& c, const F& f) {
  const double ab = squared(minus(a, b)), bc = squared(minus(b, c)), ca = squared(minus(c, a));
  if (bc >= ab && bc >= ca) return f(a, b, c);
  return ca >= ab ? f(b, c, a) : f(c, a, b);
}

}  // namespace

Box enlarged_bounding_box(std::span<const Point> xy, double share) {
  Box box{xy.front(), xy.front()};
  for (const Point& p : xy) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  // Each term by itself, lest the difference of huge numbers overflow.
  const double margin =
      std::max(share * box.high.x - share * box.low.x, share * box.high.y - share * box.low.y);
  constexpr double largest = std::numeric_limits<double>::max();
  const auto within = [&](double value) { return std::clamp(value, -largest, largest); };
  return {{within(box.low.x - margin), within(box.low.y - margin)},
          {within(box.high.x + margin), within(box.high.y + margin)}};
}

VoronoiPolygons::VoronoiPolygons(std::span<const Point> xy, const VoronoiDiagram& diagram,
                                 const Box& box)
    : xy_(xy), diagram_(diagram), outgoing_(outgoing_halfedges(diagram.dual)) {
  const std::array<double, 4> bounds{box.low.x, box.low.y, box.high.x, box.high.y};
  const bool finite =
      std::all_of(bounds.begin(), bounds.end(), [](double b) { return std::isfinite(b); });
  if (!finite || !(box.low.x < box.high.x && box.low.y < box.high.y))
    throw ParameterError(
        "the box must be finite, and its lower left corner left of and below the "
        "upper right one");
  scale(box);
  place_vertices();
}

void VoronoiPolygons::scale(const Box& box) {
  const auto size = [](const Point& p) { return std::max(std::fabs(p.x), std::fabs(p.y)); };
  exponent_ = exponent_of(std::max(size(box.low), size(box.high)));
  const auto scaled = [&](const Point& p) {
    return Point{std::ldexp(p.x, -exponent_), std::ldexp(p.y, -exponent_)};
  };
  box_ = {scaled(box.low), scaled(box.high)};
  scaled_ = Buffer<Point>(xy_.size());
  for (std::size_t v = 0; v < xy_.size(); ++v) scaled_[v] = scaled(xy_[v]);
}

void VoronoiPolygons::place_vertices() {
  const auto count = static_cast<Index>(diagram_.dual.triangle_count());
  first_at_place_ = Buffer<Index>(count);
  place_ = Buffer<Point>(count);
  unite_vertices_at_one_place();
  // Beyond this distance from the middle of the box a vertex is far: its edges leave the box there
  // along their own bisectors, as its coordinates are too coarse to say where.
  const double width = box_.high.x - box_.low.x, height = box_.high.y - box_.low.y;
  const Point middle{box_.low.x + width / 2, box_.low.y + height / 2};
  const double size = std::max(width, height), near = 16 * size;
  // Bisectors pass between points, so this far from there and towards one vertex, they are close to
  // each other and all beyond the box.
  double to_points = 0;
  for (const Point& p : scaled_)
    to_points = std::max({to_points, std::fabs(p.x - middle.x), std::fabs(p.y - middle.y)});
  reach_ = 64 * (size + to_points);
  for (Index t = 0; t < count; ++t) {
    place_[t] = place_[first_at_place_[t]];
    if (first_at_place_[t] != t) continue;
    const VertexId* const site = &diagram_.sites[std::size_t{3} * t];
    const Point p = from_best_corner(scaled_[site[0]], scaled_[site[1]], scaled_[site[2]], centre);
    const bool is_near = std::fabs(p.x - middle.x) <= near && std::fabs(p.y - middle.y) <= near;
    place_[t] = is_near ? p : Point{kNowhere, kNowhere};
  }
}

/// Vertices with one centre and two sites in common have the same circle. If there are more at the
/// same place, edges of length zero lead from one to the next.
void VoronoiPolygons::unite_vertices_at_one_place() {
  const TriangleMesh& dual = diagram_.dual;
  Buffer<Index>& first = first_at_place_;
  for (Index t = 0; t < first.size(); ++t) first[t] = t;
  const auto find = [&](Index t) {
    while (first[t] != t) t = first[t] = first[first[t]];
    return t;
  };
  const auto site = [&](Index h) { return xy_[diagram_.sites[h]]; };
  for (Index t = 0; t < first.size(); ++t) {
    const Circle circle(site(3 * t), site(3 * t + 1), site(3 * t + 2));
    for (Index h = 3 * t; h < 3 * t + 3; ++h) {
      const HalfEdgeId twin = dual.twin(HalfEdgeId(h));
      if (!twin.valid() || twin < h) continue;
      if (circle.side_plain(site(TriangleMesh::prev(twin))) != 0) continue;
      const Index a = find(t), b = find(TriangleMesh::triangle(twin));
      first[std::max(a, b)] = std::min(a, b);
    }
  }
  for (Index t = 0; t < first.size(); ++t) first[t] = find(t);
}

/// Where an edge ends at a far vertex: on the bisector of its two sites, at a distance that the
/// third one says, but no further than matters to the box.
VoronoiPolygons::Corner VoronoiPolygons::end_of_edge(HalfEdgeId h) const {
  const Point u = scaled_[diagram_.sites[h]], v = scaled_[diagram_.sites[TriangleMesh::next(h)]];
  const Point w = scaled_[diagram_.sites[TriangleMesh::prev(h)]];
  const Point wu = minus(w, u), wv = minus(w, v), uv = minus(v, u);
  const double length = std::hypot(uv.x, uv.y);
  const double area = std::max(0.0, from_best_corner(u, v, w, twice_area));
  double distance = difference_of_products(wu.x, wv.x, -wu.y, wv.y) / (2 * area) * length;
  if (!(std::fabs(distance) < reach_)) distance = distance < 0 ? -reach_ : reach_;
  const Point across = clockwise(uv);
  const double unit = length > 0 ? distance / length : 0;
  return {u.x + uv.x / 2 - unit * across.x, u.y + uv.y / 2 - unit * across.y, 1};
}

/// Where the edge of a boundary half-edge leads, seen from its vertex.
VoronoiPolygons::Corner VoronoiPolygons::direction_of_edge(HalfEdgeId h) const {
  const Point out = clockwise(minus(scaled_[diagram_.entering(h)], scaled_[diagram_.leaving(h)]));
  const double length = std::hypot(out.x, out.y);
  return length > 0 ? Corner{out.x / length, out.y / length, 0} : Corner{0, 0, 0};
}

/// The vertex of the diagram that is the triangle of h. The boundary of the cell at the origin of h
/// comes along the edge of h, and leaves along that of prev(h).
void VoronoiPolygons::append_vertex(HalfEdgeId h, std::vector<Corner>& corners) const {
  const Point& p = place_[TriangleMesh::triangle(h)];
  if (p.x == p.x) {
    corners.push_back({p.x, p.y, 1});
  } else {
    corners.push_back(end_of_edge(h));
    corners.push_back(end_of_edge(TriangleMesh::prev(h)));
  }
}

void VoronoiPolygons::corners_of(Index cell, std::vector<Corner>& corners) const {
  corners.clear();
  const HalfEdgeId first = outgoing_[cell];
  const bool unbounded = diagram_.dual.is_boundary(first);
  if (unbounded) corners.push_back(direction_of_edge(first));
  HalfEdgeId last;
  for_each_outgoing(diagram_.dual, first, [&](HalfEdgeId h) {
    append_vertex(h, corners);
    last = h;
  });
  if (!unbounded) return;
  const Corner begin = corners.front(), end = direction_of_edge(TriangleMesh::prev(last));
  corners.push_back(end);
  // From opposite directions alone nobody could tell which half-plane is meant.
  if (begin.x * end.x + begin.y * end.y < 0) {
    const Point between = clockwise({begin.x - end.x, begin.y - end.y});
    corners.push_back({between.x, between.y, 0});
  }
}

/// Computed from the inner to the outer end: the same from both cells along an edge.
VoronoiPolygons::Corner VoronoiPolygons::crossing(const Side& side, const Corner& in,
                                                  const Corner& out) {
  const auto depth = [&](const Corner& c) {
    return side.sign * (c.*side.coordinate - side.bound * c.w);
  };
  const double d_in = depth(in), d_out = -depth(out);
  Corner corner;
  if (in.w > 0 && out.w > 0) {
    const double part = d_in / (d_in + d_out);
    corner = {in.x + part * (out.x - in.x), in.y + part * (out.y - in.y), 1};
  } else {
    corner = {in.x * d_out + out.x * d_in, in.y * d_out + out.y * d_in,
              in.w * d_out + out.w * d_in};
    if (corner.w > 0) corner = {corner.x / corner.w, corner.y / corner.w, 1};
  }
  corner.*side.coordinate = side.bound * corner.w;
  return corner;
}

/// Sutherland and Hodgman's algorithm.
void VoronoiPolygons::clip(const Side& side, std::vector<Corner>& corners,
                           std::vector<Corner>& scratch) {
  scratch.clear();
  const auto is_inside = [&](const Corner& c) {
    return side.sign * (c.*side.coordinate - side.bound * c.w) >= 0;
  };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner &a = corners[i], &b = corners[i + 1 == corners.size() ? 0 : i + 1];
    const bool a_inside = is_inside(a), b_inside = is_inside(b);
    if (a_inside) scratch.push_back(a);
    if (a_inside != b_inside)
      scratch.push_back(a_inside ? crossing(side, a, b) : crossing(side, b, a));
  }
  corners.swap(scratch);
}

void VoronoiPolygons::polygon_of(Index cell, std::vector<Point>& polygon) const {
  polygon.clear();
  std::vector<Corner> corners, scratch;
  corners_of(cell, corners);
  for (const Side& side : {Side{&Corner::x, box_.low.x, 1}, Side{&Corner::y, box_.low.y, 1},
                           Side{&Corner::x, box_.high.x, -1}, Side{&Corner::y, box_.high.y, -1}})
    clip(side, corners, scratch);
  double twice_area = 0;
  for (const Corner& c : corners) {
    if (c.w == 0) continue;
    const Point p{std::ldexp(std::clamp(c.x, box_.low.x, box_.high.x), exponent_),
                  std::ldexp(std::clamp(c.y, box_.low.y, box_.high.y), exponent_)};
    if (polygon.empty() || polygon.back() != p) polygon.push_back(p);
  }
  while (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const auto from_first = [&](const Point& p) {
      const Point d = minus(p, polygon[0]);
      return Point{std::ldexp(d.x, -exponent_), std::ldexp(d.y, -exponent_)};
    };
    twice_area += cross(from_first(polygon[i - 1]), from_first(polygon[i]));
  }
  if (!(twice_area > 0)) polygon.clear();
}

}  // namespace hodt
