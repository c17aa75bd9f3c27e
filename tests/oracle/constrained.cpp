#include "constrained.h"

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>

#include "families.h"

namespace oracle {
namespace {

Edge make_edge(int u, int v) {
  return {std::min(u, v), std::max(u, v)};
}

std::array<Edge, 3> edges_of(const Triangle& t) {
  return {make_edge(t[0], t[1]), make_edge(t[1], t[2]), make_edge(t[2], t[0])};
}

enum class Ties { kPerturbed, kPlain };

/// The open disc that a triangle's circumcircle bounds.
class Disc {
 public:
  Disc(const Instance& instance, const Triangle& t, Ties ties);

  /// The vertex is inside.
  bool holds(int v) const { return inside_[v]; }
  /// The edge has a point in the disc.
  bool meets(int u, int v) const { return holds(u) || holds(v) || is_chord(u, v); }

 private:
  /// The segment has a point nearer to the centre than the radius, other than its ends.
  bool is_chord(int u, int v) const;

  const Instance& instance_;
  int origin_;
  std::vector<bool> inside_;
  // The centre is (origin_ + centre / scale), the radius the length of centre / scale.
  mpz_class scale_, centre_x_, centre_y_, radius_squared_;
};

Disc::Disc(const Instance& instance, const Triangle& t, Ties ties)
    : instance_(instance), origin_(t[0]), inside_(instance.size()) {
  for (int v = 0; v < instance.size(); ++v) {
    if (v == t[0] || v == t[1] || v == t[2]) continue;
    inside_[v] = (ties == Ties::kPlain ? instance.in_circle_plain(t[0], t[1], t[2], v)
                                       : instance.in_circle(t[0], t[1], t[2], v)) > 0;
  }
  const mpz_class bx = instance.x(t[1]) - instance.x(t[0]),
                  by = instance.y(t[1]) - instance.y(t[0]);
  const mpz_class cx = instance.x(t[2]) - instance.x(t[0]),
                  cy = instance.y(t[2]) - instance.y(t[0]);
  const mpz_class b = bx * bx + by * by, c = cx * cx + cy * cy;
  scale_ = 2 * (bx * cy - by * cx);
  centre_x_ = cy * b - by * c;
  centre_y_ = bx * c - cx * b;
  radius_squared_ = centre_x_ * centre_x_ + centre_y_ * centre_y_;
}

bool Disc::is_chord(int u, int v) const {
  // From the centre to the ends, all times the scale (whose sign does not matter).
  const mpz_class ux = scale_ * (instance_.x(u) - instance_.x(origin_)) - centre_x_;
  const mpz_class uy = scale_ * (instance_.y(u) - instance_.y(origin_)) - centre_y_;
  const mpz_class vx = scale_ * (instance_.x(v) - instance_.x(origin_)) - centre_x_;
  const mpz_class vy = scale_ * (instance_.y(v) - instance_.y(origin_)) - centre_y_;
  const mpz_class dx = vx - ux, dy = vy - uy;
  const bool is_nearest_between = ux * dx + uy * dy < 0 && vx * dx + vy * dy > 0;
  if (!is_nearest_between) return false;  // an end is nearest, and ends are asked for elsewhere
  const mpz_class cross = ux * vy - uy * vx;
  return cross * cross < radius_squared_ * (dx * dx + dy * dy);
}

/// What is inside the disc and reached from the triangles of the triangulation that begin(t) holds
/// for.
template <class Begin>
std::vector<int> reached_from(const Constrained& constrained, const Disc& disc, const Triangles& in,
                              const Begin& begin) {
  std::map<Edge, std::vector<std::size_t>> sides;
  for (std::size_t i = 0; i < in.size(); ++i) {
    for (const Edge& e : edges_of(in[i])) sides[e].push_back(i);
  }
  std::vector<std::size_t> met;
  std::vector<bool> seen(in.size());
  const auto meet = [&](std::size_t i) {
    if (!seen[i]) met.push_back(i);
    seen[i] = true;
  };
  for (std::size_t i = 0; i < in.size(); ++i) {
    if (begin(in[i])) meet(i);
  }
  std::set<int> reached;
  for (std::size_t next = 0; next < met.size(); ++next) {
    const Triangle& at = in[met[next]];
    for (const int v : at) {
      if (disc.holds(v)) reached.insert(v);
    }
    for (const Edge& e : edges_of(at)) {
      if (constrained.is_constraint(e[0], e[1]) || !disc.meets(e[0], e[1])) continue;
      for (const std::size_t i : sides[e]) meet(i);
    }
  }
  return {reached.begin(), reached.end()};
}

std::vector<int> walk(const Constrained& constrained, const Triangle& t, const Triangles& in,
                      Ties ties) {
  const Instance& instance = constrained.instance();
  const Disc disc(instance, t, ties);
  return reached_from(constrained, disc, in,
                      [&](const Triangle& other) { return instance.triangles_overlap(t, other); });
}

/// The segment has a point in the interior of the triangle (counter-clockwise).
bool enters(const Instance& instance, const Edge& segment, const Triangle& t) {
  // Each side has the part of the segment on its left, which is between two fractions of it.
  mpq_class from = 0, to = 1;
  for (int i = 0; i < 3; ++i) {
    const int a = t[i], b = t[(i + 1) % 3];
    const auto left_of_side = [&](int p) {
      return mpq_class((instance.x(b) - instance.x(a)) * (instance.y(p) - instance.y(a)) -
                       (instance.y(b) - instance.y(a)) * (instance.x(p) - instance.x(a)));
    };
    const mpq_class at_u = left_of_side(segment[0]), at_v = left_of_side(segment[1]);
    if (at_u <= 0 && at_v <= 0) return false;
    if (at_u < 0) from = std::max(from, mpq_class(at_u / (at_u - at_v)));
    if (at_v < 0) to = std::min(to, mpq_class(at_u / (at_u - at_v)));
  }
  return from < to;
}

}  // namespace

// ---- Constraints ----------------------------------------------------------------------------

Constrained::Constrained(const Instance& instance, std::vector<Edge> edges)
    : instance_(instance), edges_(std::move(edges)) {
  if (instance.all_collinear()) throw std::invalid_argument("collinear points");
  for (Edge& e : edges_) {
    e = make_edge(e[0], e[1]);
    if (e[0] < 0 || e[1] >= instance.size() || e[0] == e[1] ||
        !instance.is_segment_free(e[0], e[1])) {
      throw std::invalid_argument("no edge between two points");
    }
  }
  std::sort(edges_.begin(), edges_.end());
  edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  for (const Edge& e : edges_) {
    if (!is_edge_possible(e[0], e[1])) throw std::invalid_argument("constraints cross");
  }
}

bool Constrained::is_constraint(int u, int v) const {
  return std::binary_search(edges_.begin(), edges_.end(), make_edge(u, v));
}

bool Constrained::is_edge_possible(int u, int v) const {
  return instance_.is_segment_free(u, v) &&
         std::none_of(edges_.begin(), edges_.end(),
                      [&](const Edge& e) { return instance_.segments_cross(u, v, e[0], e[1]); });
}

bool Constrained::is_triangle_possible(const Triangle& t) const {
  // A constraint that meets the interior of an empty triangle leaves it through an edge.
  return instance_.is_triangle_empty(t[0], t[1], t[2]) && is_edge_possible(t[0], t[1]) &&
         is_edge_possible(t[1], t[2]) && is_edge_possible(t[2], t[0]);
}

Triangles Constrained::possible_triangles() const {
  Triangles possible = instance_.empty_triangles(kUnrestricted);
  std::erase_if(possible, [&](const Triangle& t) { return !is_triangle_possible(t); });
  return possible;
}

Triangles Constrained::some_triangulation(const std::vector<Edge>& with) const {
  std::vector<Edge> chosen = edges_;
  const auto add = [&](const Edge& edge) {
    const bool fits = std::none_of(chosen.begin(), chosen.end(), [&](const Edge& e) {
      return e == edge || instance_.segments_cross(e[0], e[1], edge[0], edge[1]);
    });
    if (fits) chosen.push_back(edge);
  };
  for (const Edge& e : with) add(make_edge(e[0], e[1]));
  for (int v = 0; v < instance_.size(); ++v) {
    for (int u = 0; u < v; ++u) {
      if (instance_.is_segment_free(u, v)) add({u, v});
    }
  }
  std::sort(chosen.begin(), chosen.end());
  // No further edge fits, so the faces are triangles, and the empty triangles of edges are faces.
  Triangles faces = instance_.empty_triangles(kUnrestricted);
  std::erase_if(faces, [&](const Triangle& t) {
    return !std::ranges::all_of(edges_of(t), [&](const Edge& e) {
      return std::binary_search(chosen.begin(), chosen.end(), e);
    });
  });
  return faces;
}

// ---- Orders ---------------------------------------------------------------------------------

std::vector<int> Constrained::reachable_inside(const Triangle& t,
                                               const Triangles& triangulation) const {
  return walk(*this, t, triangulation, Ties::kPerturbed);
}

std::vector<int> Constrained::reachable_inside(const Triangle& t) const {
  if (!is_triangle_possible(t)) throw std::invalid_argument("no possible triangle");
  const auto edges = edges_of(t);
  return reachable_inside(t, some_triangulation({edges.begin(), edges.end()}));
}

int Constrained::triangle_order(const Triangle& t) const {
  Triangle sorted = t;
  std::sort(sorted.begin(), sorted.end());
  const auto known = orders_.find(sorted);
  if (known != orders_.end()) return known->second;
  return orders_[sorted] = static_cast<int>(reachable_inside(t).size());
}

int Constrained::triangle_order_plain(const Triangle& t) const {
  if (!is_triangle_possible(t)) throw std::invalid_argument("no possible triangle");
  const auto edges = edges_of(t);
  const Triangles triangulation = some_triangulation({edges.begin(), edges.end()});
  return static_cast<int>(walk(*this, t, triangulation, Ties::kPlain).size());
}

int Constrained::order(const Triangles& triangles) const {
  int largest = 0;
  for (const Triangle& t : triangles) largest = std::max(largest, triangle_order(t));
  return largest;
}

int Constrained::order_plain(const Triangles& triangles) const {
  int largest = 0;
  for (const Triangle& t : triangles) largest = std::max(largest, triangle_order_plain(t));
  return largest;
}

Triangles Constrained::delaunay() const {
  Triangles triangles = possible_triangles();
  std::erase_if(triangles, [&](const Triangle& t) { return triangle_order(t) > 0; });
  return triangles;
}

std::optional<int> Constrained::useful_order_by_lemma(int u, int v) const {
  if (!is_edge_possible(u, v)) return std::nullopt;
  if (is_constraint(u, v)) return 0;
  std::vector<Edge> edges = edges_;
  edges.push_back({u, v});
  const Constrained with_edge(instance_, std::move(edges));
  int order = 0;
  for (int w = 0; w < instance_.size(); ++w) {
    const Triangle t{u, v, w};
    if (w == u || w == v || !is_triangle_possible(t)) continue;
    if (with_edge.triangle_order(t) == 0) order = std::max(order, triangle_order(t));
  }
  return order;
}

std::optional<int> Constrained::edge_order(int u, int v) const {
  if (!is_edge_possible(u, v)) return std::nullopt;
  if (is_constraint(u, v)) return 0;
  const Triangles in = some_triangulation({{u, v}});
  int order = instance_.size();
  for (int w = 0; w < instance_.size(); ++w) {
    const int turn = instance_.orient(u, v, w);
    if (turn == 0) continue;
    const Disc disc(instance_, turn > 0 ? Triangle{u, v, w} : Triangle{v, u, w}, Ties::kPerturbed);
    const auto reached = reached_from(*this, disc, in, [&](const Triangle& t) {
      return std::ranges::count(t, u) > 0 && std::ranges::count(t, v) > 0;
    });
    order = std::min(order, static_cast<int>(reached.size()));
  }
  return order;
}

std::optional<int> Constrained::open_triangle_order(const Triangle& t) const {
  const int turn = instance_.orient(t[0], t[1], t[2]);
  if (turn == 0) return std::nullopt;
  const Triangle turned = turn > 0 ? t : Triangle{t[0], t[2], t[1]};
  for (const Edge& e : edges_) {
    if (enters(instance_, e, turned)) return std::nullopt;
  }
  return static_cast<int>(walk(*this, turned, some_triangulation(), Ties::kPerturbed).size());
}

// ---- All triangulations ---------------------------------------------------------------------

std::vector<OrderedTriangle> Constrained::possible_triangles_with_orders() const {
  std::vector<OrderedTriangle> triangles;
  for (const Triangle& t : possible_triangles()) triangles.push_back({t, triangle_order(t)});
  return triangles;
}

void Constrained::for_each_triangulation(
    int max_order, const std::function<void(const Triangles&, int)>& visit) const {
  // A triangulation contains each free segment that none of its edges crosses.
  std::vector<OrderedTriangle> triangles = possible_triangles_with_orders();
  std::erase_if(triangles, [&](const OrderedTriangle& t) { return t.order > max_order; });
  oracle::for_each_triangulation(instance_, triangles, visit);
}

std::vector<Edge> random_constraints(const Instance& instance, int count, std::uint64_t seed) {
  std::vector<Edge> pairs;
  for (int v = 0; v < instance.size(); ++v) {
    for (int u = 0; u < v; ++u) {
      if (instance.is_segment_free(u, v)) pairs.push_back({u, v});
    }
  }
  families::Random(seed).shuffle(pairs);
  std::vector<Edge> chosen;
  for (const Edge& pair : pairs) {
    if (static_cast<int>(chosen.size()) >= count) break;
    const bool crosses = std::any_of(chosen.begin(), chosen.end(), [&](const Edge& e) {
      return instance.segments_cross(e[0], e[1], pair[0], pair[1]);
    });
    if (!crosses) chosen.push_back(pair);
  }
  return chosen;
}

// ---- Domains --------------------------------------------------------------------------------

bool is_in_domain(const Instance& instance, const Rings& rings, const Triangle& t) {
  // Three times the centroid, against three times the points.
  const mpz_class x = instance.x(t[0]) + instance.x(t[1]) + instance.x(t[2]);
  const mpz_class y = instance.y(t[0]) + instance.y(t[1]) + instance.y(t[2]);
  bool inside = false;
  for (const std::vector<int>& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      int low = ring[i], high = ring[(i + 1) % ring.size()];
      if (instance.y(low) > instance.y(high)) std::swap(low, high);
      // The ray to the right of the centroid; an edge has its lower end, but not its upper one.
      if (3 * instance.y(low) > y || 3 * instance.y(high) <= y) continue;
      const mpz_class dx = instance.x(high) - instance.x(low);
      const mpz_class dy = instance.y(high) - instance.y(low);
      const mpz_class left_of_edge =
          dx * (y - 3 * instance.y(low)) - dy * (x - 3 * instance.x(low));
      if (left_of_edge > 0) inside = !inside;
    }
  }
  return inside;
}

namespace {

void require_constraints(const Constrained& constrained, const Rings& rings) {
  for (const std::vector<int>& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (!constrained.is_constraint(ring[i], ring[(i + 1) % ring.size()])) {
        throw std::invalid_argument("an edge of a ring is no constraint");
      }
    }
  }
}

std::vector<OrderedTriangle> up_to(std::vector<OrderedTriangle> triangles, int max_order) {
  std::erase_if(triangles, [&](const OrderedTriangle& t) { return t.order > max_order; });
  return triangles;
}

std::vector<OrderedTriangle> triangles_of_domain(const Constrained& constrained,
                                                 const Rings& domain) {
  require_constraints(constrained, domain);
  std::vector<OrderedTriangle> triangles = constrained.possible_triangles_with_orders();
  std::erase_if(triangles, [&](const OrderedTriangle& t) {
    return !is_in_domain(constrained.instance(), domain, t.triangle);
  });
  return triangles;
}

std::vector<Triangulation> triangulations_of_domain(const Constrained& constrained,
                                                    const Rings& domain) {
  std::set<Triangles> different;
  constrained.for_each_triangulation(kUnrestricted, [&](const Triangles& all, int) {
    Triangles inside;
    for (const Triangle& t : all) {
      if (is_in_domain(constrained.instance(), domain, t)) inside.push_back(t);
    }
    std::sort(inside.begin(), inside.end());
    different.insert(inside);
  });
  std::vector<Triangulation> triangulations;
  for (const Triangles& inside : different) {
    triangulations.push_back({inside, constrained.order(inside)});
  }
  return triangulations;
}

}  // namespace

ConstrainedCatalogue::ConstrainedCatalogue(const Constrained& constrained, int max_order)
    : Catalogue(
          constrained.instance(), constrained.possible_triangles_with_orders(),
          list_triangulations(constrained.instance(),
                              up_to(constrained.possible_triangles_with_orders(), max_order))) {}

ConstrainedCatalogue::ConstrainedCatalogue(const Constrained& constrained, const Rings& domain)
    : Catalogue(constrained.instance(), triangles_of_domain(constrained, domain),
                triangulations_of_domain(constrained, domain)) {}

std::vector<bool> boundary_vertices(const Instance& instance, const Triangles& triangles) {
  std::map<Edge, int> times;
  for (const Triangle& t : triangles) {
    for (const Edge& e : edges_of(t)) ++times[e];
  }
  std::vector<bool> boundary(instance.size());
  for (const auto& [edge, number] : times) {
    if (number == 1) boundary[edge[0]] = boundary[edge[1]] = true;
  }
  return boundary;
}

}  // namespace oracle
