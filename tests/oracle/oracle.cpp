#include "oracle.h"

#include <algorithm>
#include <bit>
#include <bitset>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <stdexcept>

namespace oracle {
namespace {

constexpr std::int8_t kUnknown = 2;

std::size_t choose2(std::size_t n) {
  return n * (n - 1) / 2;
}
std::size_t choose3(std::size_t n) {
  return n < 3 ? 0 : n * (n - 1) * (n - 2) / 6;
}
std::size_t choose4(std::size_t n) {
  return n < 4 ? 0 : choose3(n) * (n - 3) / 4;
}

/// The place of i < j < k in the list of all triples, and of i < j < k < l in that of quadruples.
std::size_t place(int i, int j, int k) {
  return choose3(k) + (j ? choose2(j) : 0) + i;
}
std::size_t place(int i, int j, int k, int l) {
  return choose4(l) + place(i, j, k);
}

/// Sorts a few numbers and returns the sign of the permutation.
template <std::size_t N>
int sort_with_parity(std::array<int, N>& a) {
  int parity = 1;
  for (std::size_t i = 1; i < N; ++i) {
    for (std::size_t j = i; j > 0 && a[j - 1] > a[j]; --j) {
      std::swap(a[j - 1], a[j]);
      parity = -parity;
    }
  }
  return parity;
}

Edge make_edge(int u, int v) {
  return {std::min(u, v), std::max(u, v)};
}

}  // namespace

// ---- The point set --------------------------------------------------------------------------

Instance::Instance(const Points& points, const Heights& z) : points_(points) {
  std::vector<RationalPoint> exact;
  std::set<std::pair<double, double>> seen;
  for (const auto& [x, y] : points) {
    if (!std::isfinite(x) || !std::isfinite(y)) throw std::invalid_argument("not finite");
    if (!seen.insert({x, y}).second) throw std::invalid_argument("two equal points");
    exact.push_back({mpq_class(x), mpq_class(y)});
  }
  scale_to_integers(exact);
  fill_orientations();
  rank_lexicographically();
  find_hull();
  plain_sign_.assign(choose4(stride()), kUnknown);
  perturbed_sign_.assign(choose4(stride()), kUnknown);
  set_heights(z);
}

void Instance::scale_to_integers(const std::vector<RationalPoint>& exact) {
  mpz_class scale = 1;  // every denominator is a power of two, so the largest is divided by all
  for (const RationalPoint& p : exact) {
    scale = std::max({scale, mpz_class(p.x.get_den()), mpz_class(p.y.get_den())});
  }
  for (const RationalPoint& p : exact) {
    x_.push_back(mpz_class(p.x.get_num() * (scale / p.x.get_den())));
    y_.push_back(mpz_class(p.y.get_num() * (scale / p.y.get_den())));
    lift_.push_back(mpz_class(x_.back() * x_.back() + y_.back() * y_.back()));
  }
}

void Instance::fill_orientations() {
  const int n = size();
  orient_.assign(stride() * stride() * stride(), 0);
  double_area_.resize(choose3(stride()));
  for (int k = 0; k < n; ++k) {
    for (int j = 0; j < k; ++j) {
      for (int i = 0; i < j; ++i) {
        mpz_class& area = double_area_[place(i, j, k)];
        area = (x_[j] - x_[i]) * (y_[k] - y_[i]) - (x_[k] - x_[i]) * (y_[j] - y_[i]);
        const auto set = [&](int a, int b, int c, int sign) {
          orient_[(a * stride() + b) * stride() + c] = static_cast<std::int8_t>(sign);
        };
        const int s = sgn(area);
        set(i, j, k, s), set(j, k, i, s), set(k, i, j, s);
        set(j, i, k, -s), set(i, k, j, -s), set(k, j, i, -s);
      }
    }
  }
}

void Instance::rank_lexicographically() {
  std::vector<int> sorted(points_.size());
  std::iota(sorted.begin(), sorted.end(), 0);
  std::sort(sorted.begin(), sorted.end(), [&](int a, int b) { return points_[a] < points_[b]; });
  lexicographic_rank_.resize(points_.size());
  for (int r = 0; r < size(); ++r) lexicographic_rank_[sorted[r]] = r;
}

void Instance::set_heights(const Heights& z) {
  if (!z.empty() && z.size() != points_.size()) throw std::invalid_argument("heights and points");
  z_ = z;
  std::vector<int> sorted(z.size());
  std::iota(sorted.begin(), sorted.end(), 0);
  std::sort(sorted.begin(), sorted.end(), [&](int a, int b) {
    return std::make_pair(z_[a], points_[a]) < std::make_pair(z_[b], points_[b]);
  });
  height_rank_.resize(z.size());
  for (std::size_t r = 0; r < z.size(); ++r) height_rank_[sorted[r]] = static_cast<int>(r);
}

const mpz_class& Instance::double_area_of_sorted(int i, int j, int k) const {
  return double_area_[place(i, j, k)];
}

// ---- In circle ------------------------------------------------------------------------------
//
// With rows (x, y, x² + y², 1) for a, b, c, d the determinant is positive if d is inside the circle
// of a counter-clockwise a, b, c. Expanded along its third column it is
//   w_a [bcd] - w_b [acd] + w_c [abd] - w_d [abc],
// where [pqr] is twice the signed area. (Only d lowered from the plane through the others: the
// determinant is then -w_d [abc] > 0, which fixes the sign.)

int Instance::determinant_sign(int i, int j, int k, int l) const {
  const mpz_class sum =
      lift_[i] * double_area_of_sorted(j, k, l) - lift_[j] * double_area_of_sorted(i, k, l) +
      lift_[k] * double_area_of_sorted(i, j, l) - lift_[l] * double_area_of_sorted(i, j, k);
  return sgn(sum);
}

/// Raising w_m by ε_m adds ε_m times its coefficient in the expansion, and nothing else: no two ε
/// are ever multiplied. So if the determinant is zero, the largest ε whose coefficient is not zero
/// decides.
int Instance::perturbed_determinant_sign(int i, int j, int k, int l) const {
  if (const int sign = determinant_sign(i, j, k, l)) return sign;
  struct Term {
    int rank;
    int coefficient;
  };
  std::array<Term, 4> terms{{{lexicographic_rank_[i], orient(j, k, l)},
                             {lexicographic_rank_[j], -orient(i, k, l)},
                             {lexicographic_rank_[k], orient(i, j, l)},
                             {lexicographic_rank_[l], -orient(i, j, k)}}};
  std::sort(terms.begin(), terms.end(), [](Term a, Term b) { return a.rank > b.rank; });
  for (const Term& term : terms) {
    if (term.coefficient) return term.coefficient;
  }
  return 0;  // all four are collinear
}

template <class Sign>
int Instance::sign_of_quadruple(std::array<int, 4> q, std::vector<std::int8_t>& memo,
                                Sign sign) const {
  const int parity = sort_with_parity(q);
  std::int8_t& known = memo[place(q[0], q[1], q[2], q[3])];
  if (known == kUnknown) known = static_cast<std::int8_t>(sign(q[0], q[1], q[2], q[3]));
  return parity * known;
}

int Instance::in_circle_plain(int i, int j, int k, int l) const {
  const auto sign = [&](int a, int b, int c, int d) { return determinant_sign(a, b, c, d); };
  return orient(i, j, k) * sign_of_quadruple({i, j, k, l}, plain_sign_, sign);
}

int Instance::in_circle(int i, int j, int k, int l) const {
  const auto sign = [&](int a, int b, int c, int d) {
    return perturbed_determinant_sign(a, b, c, d);
  };
  return orient(i, j, k) * sign_of_quadruple({i, j, k, l}, perturbed_sign_, sign);
}

// ---- Segments, triangles, hull --------------------------------------------------------------

bool Instance::all_collinear() const {
  return std::all_of(orient_.begin(), orient_.end(), [](int sign) { return sign == 0; });
}

bool Instance::is_segment_free(int u, int v) const {
  for (int w = 0; w < size(); ++w) {
    if (w == u || w == v || orient(u, v, w) != 0) continue;
    // On one line, between in the lexicographic order is between on the line.
    const auto [low, high] = std::minmax(lexicographic_rank_[u], lexicographic_rank_[v]);
    if (low < lexicographic_rank_[w] && lexicographic_rank_[w] < high) return false;
  }
  return true;
}

bool Instance::segments_cross(int a, int b, int c, int d) const {
  return orient(a, b, c) * orient(a, b, d) < 0 && orient(c, d, a) * orient(c, d, b) < 0;
}

bool Instance::is_triangle_empty(int a, int b, int c) const {
  const int turn = orient(a, b, c);
  if (turn == 0) return false;
  for (int p = 0; p < size(); ++p) {
    if (p == a || p == b || p == c) continue;
    if (turn * orient(a, b, p) >= 0 && turn * orient(b, c, p) >= 0 && turn * orient(c, a, p) >= 0) {
      return false;
    }
  }
  return true;
}

bool Instance::is_hull_half_edge(int u, int v) const {
  for (int w = 0; w < size(); ++w) {
    if (orient(u, v, w) < 0) return false;
  }
  return is_segment_free(u, v);
}

void Instance::find_hull() {
  on_hull_.assign(points_.size(), false);
  for (int u = 0; u < size(); ++u) {
    for (int v = 0; v < size(); ++v) {
      if (u != v && is_hull_half_edge(u, v)) on_hull_[u] = on_hull_[v] = true;
    }
  }
}

bool Instance::triangles_overlap(const Triangle& s, const Triangle& t) const {
  // Two convex polygons have no interior point in common exactly if the line through an edge of
  // one of them has the two on different sides.
  const auto separates = [&](const Triangle& a, const Triangle& b) {
    const int turn = orient(a[0], a[1], a[2]);
    for (int i = 0; i < 3; ++i) {
      const int p = a[i], q = a[(i + 1) % 3];
      if (std::all_of(b.begin(), b.end(), [&](int w) { return turn * orient(p, q, w) <= 0; })) {
        return true;
      }
    }
    return false;
  };
  return !separates(s, t) && !separates(t, s);
}

// ---- Orders ---------------------------------------------------------------------------------

int Instance::triangle_order(int a, int b, int c) const {
  int inside = 0;
  for (int p = 0; p < size(); ++p) {
    if (p != a && p != b && p != c) inside += in_circle(a, b, c, p) > 0;
  }
  return inside;
}

int Instance::triangle_order_plain(int a, int b, int c) const {
  int inside = 0;
  for (int p = 0; p < size(); ++p) {
    if (p != a && p != b && p != c) inside += in_circle_plain(a, b, c, p) > 0;
  }
  return inside;
}

int Instance::order(const Triangles& triangles) const {
  int largest = 0;
  for (const auto& [a, b, c] : triangles) largest = std::max(largest, triangle_order(a, b, c));
  return largest;
}

int Instance::order_plain(const Triangles& triangles) const {
  int largest = 0;
  for (const auto& [a, b, c] : triangles) {
    largest = std::max(largest, triangle_order_plain(a, b, c));
  }
  return largest;
}

std::optional<int> Instance::edge_order(int u, int v) const {
  if (all_collinear() || !is_segment_free(u, v)) return std::nullopt;
  // The pencil of circles through u and v, swept from the half-plane right of uv to that left of
  // it. A point on the left is outside until the circle meets it, then inside; on the right the
  // other way round; on the line but not on the segment, always outside.
  std::vector<int> met;
  for (int w = 0; w < size(); ++w) {
    if (orient(u, v, w) != 0) met.push_back(w);
  }
  std::sort(met.begin(), met.end(), [&](int a, int b) {
    if (a == b) return false;
    const bool b_inside_at_a = in_circle(u, v, a, b) > 0;
    return orient(u, v, b) > 0 ? !b_inside_at_a : b_inside_at_a;
  });
  int inside = 0;
  for (const int w : met) inside += orient(u, v, w) < 0;
  int least = inside;
  for (const int w : met) {
    inside += orient(u, v, w);
    least = std::min(least, inside);
  }
  return least;
}

std::optional<int> Instance::first_point(int u, int v, int side) const {
  std::optional<int> first;
  for (int w = 0; w < size(); ++w) {
    if (orient(u, v, w) != side) continue;
    if (!first || in_circle(u, v, *first, w) > 0) first = w;
  }
  return first;
}

std::optional<int> Instance::useful_order_by_lemma(int u, int v) const {
  if (all_collinear() || !is_segment_free(u, v)) return std::nullopt;
  int order = 0;
  for (const int side : {1, -1}) {
    if (const auto s = first_point(u, v, side)) order = std::max(order, triangle_order(u, v, *s));
  }
  return order;
}

Triangles Instance::delaunay() const {
  Triangles triangles;
  for (int a = 0; a < size(); ++a) {
    for (int b = a + 1; b < size(); ++b) {
      for (int c = b + 1; c < size(); ++c) {
        if (orient(a, b, c) == 0) continue;
        bool empty = true;
        for (int p = 0; p < size() && empty; ++p) {
          if (p != a && p != b && p != c) empty = in_circle(a, b, c, p) < 0;
        }
        if (empty) triangles.push_back({a, b, c});
      }
    }
  }
  return canonical(triangles);
}

Triangles Instance::empty_triangles(int max_order) const {
  Triangles triangles;
  for (int a = 0; a < size(); ++a) {
    for (int b = a + 1; b < size(); ++b) {
      for (int c = b + 1; c < size(); ++c) {
        if (is_triangle_empty(a, b, c) && triangle_order(a, b, c) <= max_order) {
          triangles.push_back({a, b, c});
        }
      }
    }
  }
  return canonical(triangles);
}

Triangles Instance::hull_of_edge(int u, int v) const {
  Triangles crossed;
  for (const Triangle& t : delaunay()) {
    // A segment that ends in points and passes through none meets the interior exactly if it
    // crosses an edge: it cannot lie inside, as triangles are empty.
    for (int i = 0; i < 3; ++i) {
      if (segments_cross(u, v, t[i], t[(i + 1) % 3])) {
        crossed.push_back(t);
        break;
      }
    }
  }
  return crossed;
}

// ---- Heights --------------------------------------------------------------------------------

ExtremaCount Instance::count_extrema(const Triangles& triangles) const {
  return count_extrema(triangles, on_hull_);
}

ExtremaCount Instance::count_extrema(const Triangles& triangles,
                                     const std::vector<bool>& boundary) const {
  if (z_.empty()) throw std::invalid_argument("no heights");
  std::vector<std::set<int>> neighbours(points_.size());
  for (const Triangle& t : triangles) {
    for (const int a : t) {
      for (const int b : t) {
        if (a != b) neighbours[a].insert(b);
      }
    }
  }
  ExtremaCount count;
  const auto add = [](SplitCount& to, bool at_boundary) {
    ++(at_boundary ? to.boundary : to.interior);
  };
  std::vector<bool> seen(points_.size());
  for (int v = 0; v < size(); ++v) {
    if (neighbours[v].empty()) continue;
    bool has_lower = false, has_higher = false;
    for (const int w : neighbours[v]) (is_lower(w, v) ? has_lower : has_higher) = true;
    if (!has_lower) add(count.minima, boundary[v]);
    if (!has_higher) add(count.maxima, boundary[v]);
    if (seen[v]) continue;
    // The set of equal height that v is in.
    std::vector<int> level{v};
    seen[v] = true;
    bool drains = false, touches_boundary = false;
    for (std::size_t i = 0; i < level.size(); ++i) {
      touches_boundary = touches_boundary || boundary[level[i]];
      for (const int w : neighbours[level[i]]) {
        drains = drains || z_[w] < z_[v];
        if (z_[w] == z_[v] && !seen[w]) {
          seen[w] = true;
          level.push_back(w);
        }
      }
    }
    if (!drains) add(count.pits, touches_boundary);
  }
  return count;
}

// ---- Checks ---------------------------------------------------------------------------------

Triangles Instance::canonical(const Triangles& triangles) const {
  Triangles result = triangles;
  for (Triangle& t : result) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    if (orient(t[0], t[1], t[2]) < 0) std::swap(t[1], t[2]);
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::string Instance::why_not_triangulation(const Triangles& triangles) const {
  const auto name = [](const Triangle& t) {
    std::ostringstream text;
    text << '(' << t[0] << ' ' << t[1] << ' ' << t[2] << ')';
    return text.str();
  };
  mpz_class covered = 0;
  for (const Triangle& t : triangles) {
    for (const int v : t) {
      if (v < 0 || v >= size()) return "a corner that is no point: " + name(t);
    }
    if (!is_triangle_empty(t[0], t[1], t[2])) return "degenerate or not empty: " + name(t);
    Triangle sorted = t;
    std::sort(sorted.begin(), sorted.end());
    covered += abs(double_area_of_sorted(sorted[0], sorted[1], sorted[2]));
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (triangles_overlap(triangles[i], triangles[j])) {
        return "overlap: " + name(triangles[i]) + " " + name(triangles[j]);
      }
    }
  }
  mpz_class hull = 0;  // the shoelace sum
  for (int u = 0; u < size(); ++u) {
    for (int v = 0; v < size(); ++v) {
      if (u != v && is_hull_half_edge(u, v)) hull += x_[u] * y_[v] - x_[v] * y_[u];
    }
  }
  if (covered != hull) return "does not cover the convex hull";
  return "";
}

// ---- All triangulations ---------------------------------------------------------------------

namespace {

/// Builds triangulations triangle by triangle. A half-edge is open if its left side, which must be
/// covered, is not yet: at first those of the hull. A triangulation has exactly one triangle at an
/// open half-edge, so trying all of them, always at a half-edge that depends on nothing but the
/// state, finds every triangulation once.
class Enumerator {
 public:
  using Visit = std::function<void(const Triangles&, int)>;

  Enumerator(const Instance& instance, const std::vector<OrderedTriangle>& candidates,
             const Visit& visit)
      : n_(instance.size()),
        candidates_(candidates),
        at_(static_cast<std::size_t>(n_) * n_),
        visit_(visit) {
    if (candidates_.size() > kMaxCandidates) throw std::length_error("too many triangles");
    std::vector<int> open;
    for (int u = 0; u < n_; ++u) {
      for (int v = 0; v < n_; ++v) {
        if (u != v && instance.is_hull_half_edge(u, v)) open.push_back(half_edge(u, v));
      }
    }
    prepare(instance);
    Set all;
    for (std::size_t i = 0; i < candidates_.size(); ++i) all.set(i);
    if (!instance.all_collinear()) extend(all, open, 0);
  }

 private:
  static constexpr std::size_t kMaxCandidates = 576;
  using Set = std::bitset<kMaxCandidates>;

  int half_edge(int u, int v) const { return u * n_ + v; }
  int opposite(int h) const { return half_edge(h % n_, h / n_); }

  void prepare(const Instance& instance) {
    compatible_.resize(candidates_.size());
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      const Triangle& t = candidates_[i].triangle;
      for (int e = 0; e < 3; ++e) at_[half_edge(t[e], t[(e + 1) % 3])].push_back(i);
      for (std::size_t j = 0; j < i; ++j) {
        if (instance.triangles_overlap(t, candidates_[j].triangle)) continue;
        compatible_[i].set(j);
        compatible_[j].set(i);
      }
    }
  }

  /// The open half-edge with the fewest candidates: dead ends show early.
  int tightest(const Set& available, const std::vector<int>& open) const {
    int best = open.front();
    std::size_t fewest = kMaxCandidates + 1;
    for (const int h : open) {
      std::size_t number = 0;
      for (const std::size_t i : at_[h]) number += available[i];
      if (number < fewest) {
        fewest = number;
        best = h;
      }
    }
    return best;
  }

  void extend(const Set& available, const std::vector<int>& open, int order) {
    if (open.empty()) {
      visit_(chosen_, order);
      return;
    }
    for (const std::size_t i : at_[tightest(available, open)]) {
      if (!available[i]) continue;
      std::vector<int> still_open = open;
      const auto& [t, t_order] = candidates_[i];
      for (int e = 0; e < 3; ++e) {
        const int h = half_edge(t[e], t[(e + 1) % 3]);
        const auto found = std::find(still_open.begin(), still_open.end(), h);
        if (found != still_open.end()) {
          still_open.erase(found);
        } else {
          still_open.push_back(opposite(h));
        }
      }
      chosen_.push_back(t);
      extend(available & compatible_[i], still_open, std::max(order, t_order));
      chosen_.pop_back();
    }
  }

  int n_;
  const std::vector<OrderedTriangle>& candidates_;
  std::vector<Set> compatible_;
  std::vector<std::vector<std::size_t>> at_;  // candidates on the left of a half-edge
  Triangles chosen_;
  const Visit& visit_;
};

std::vector<OrderedTriangle> with_orders(const Instance& instance, const Triangles& triangles) {
  std::vector<OrderedTriangle> with;
  for (const Triangle& t : triangles) {
    with.push_back({t, instance.triangle_order(t[0], t[1], t[2])});
  }
  return with;
}

}  // namespace

void for_each_triangulation(const Instance& instance, const std::vector<OrderedTriangle>& triangles,
                            const std::function<void(const Triangles&, int)>& visit) {
  Enumerator(instance, triangles, visit);
}

void for_each_triangulation(const Instance& instance, int max_order,
                            const std::function<void(const Triangles&, int)>& visit) {
  for_each_triangulation(instance, with_orders(instance, instance.empty_triangles(max_order)),
                         visit);
}

std::size_t count_triangulations(const Instance& instance, int max_order) {
  std::size_t count = 0;
  for_each_triangulation(instance, max_order, [&](const Triangles&, int) { ++count; });
  return count;
}

// ---- The catalogue --------------------------------------------------------------------------

int Optima::at(const std::vector<int>& of, int k) {
  return of[std::min(static_cast<std::size_t>(k), of.size() - 1)];
}

std::vector<Triangulation> list_triangulations(const Instance& instance,
                                               const std::vector<OrderedTriangle>& triangles) {
  std::vector<Triangulation> all;
  for_each_triangulation(instance, triangles, [&](const Triangles& chosen, int order) {
    all.push_back({chosen, order});
    std::sort(all.back().triangles.begin(), all.back().triangles.end());
  });
  return all;
}

Catalogue::Catalogue(const Instance& instance, int max_order)
    : Catalogue(instance, with_orders(instance, instance.empty_triangles(kUnrestricted)),
                list_triangulations(instance,
                                    with_orders(instance, instance.empty_triangles(max_order)))) {}

Catalogue::Catalogue(const Instance& instance, std::vector<OrderedTriangle> triangles,
                     std::vector<Triangulation> triangulations)
    : instance_(instance),
      triangles_(std::move(triangles)),
      triangulations_(std::move(triangulations)) {
  const std::size_t n = instance.size();
  useful_.assign(n * n, kUnrestricted);
  for (const auto& [chosen, order] : triangulations_) {
    for (const Triangle& t : chosen) {
      for (const int a : t) {
        for (const int b : t) {
          if (a != b) useful_[a * n + b] = std::min(useful_[a * n + b], order);
        }
      }
    }
  }
}

std::optional<int> Catalogue::useful_order(int u, int v) const {
  const int order = useful_[static_cast<std::size_t>(u) * instance_.size() + v];
  if (order == kUnrestricted) return std::nullopt;
  return order;
}

std::optional<int> Catalogue::least_order_with(const Triangle& triangle) const {
  const Triangle wanted = instance_.canonical({triangle}).front();
  std::optional<int> least;
  for (const Triangulation& t : triangulations_) {
    if (least && t.order >= *least) continue;
    if (std::binary_search(t.triangles.begin(), t.triangles.end(), wanted)) least = t.order;
  }
  return least;
}

std::vector<Edge> Catalogue::useful_edges(int k) const {
  std::vector<Edge> edges;
  for (int u = 0; u < instance_.size(); ++u) {
    for (int v = u + 1; v < instance_.size(); ++v) {
      const auto order = useful_order(u, v);
      if (order && *order <= k) edges.push_back({u, v});
    }
  }
  return edges;
}

std::vector<Edge> Catalogue::fixed_edges(int k) const {
  const std::vector<Edge> useful = useful_edges(k);
  std::vector<Edge> fixed;
  for (const Edge& e : useful) {
    const bool crossed = std::any_of(useful.begin(), useful.end(), [&](const Edge& f) {
      return instance_.segments_cross(e[0], e[1], f[0], f[1]);
    });
    if (!crossed) fixed.push_back(e);
  }
  return fixed;
}

std::vector<Edge> Catalogue::edges_in_all(int k) const {
  std::map<Edge, std::size_t> times;
  std::size_t total = 0;
  for (const Triangulation& t : triangulations_) {
    if (t.order > k) continue;
    ++total;
    std::set<Edge> edges;
    for (const auto& [a, b, c] : t.triangles) {
      edges.insert({make_edge(a, b), make_edge(b, c), make_edge(c, a)});
    }
    for (const Edge& e : edges) ++times[e];
  }
  std::vector<Edge> in_all;
  for (const auto& [edge, number] : times) {
    if (number == total) in_all.push_back(edge);
  }
  return in_all;
}

Triangles Catalogue::valid_triangles(int k) const {
  Triangles valid;
  for (const auto& [t, t_order] : triangles_) {
    bool is_valid = t_order <= k;
    for (int i = 0; i < 3 && is_valid; ++i) {
      const auto order = useful_order(t[i], t[(i + 1) % 3]);
      is_valid = order && *order <= k;
    }
    if (is_valid) valid.push_back(t);
  }
  return valid;
}

Optima Catalogue::optima(const Instance& heights) const {
  const int n = heights.size();
  if (n > 64) throw std::length_error("a catalogue of more than 64 points");
  const std::size_t orders = std::max(1, n - 2);
  Optima best{std::vector<int>(orders, n), std::vector<int>(orders, n),
              std::vector<int>(orders, 2 * n)};
  for (const Triangulation& t : triangulations_) {
    std::uint64_t has_lower = 0, has_higher = 0;
    for (const Triangle& corners : t.triangles) {
      for (int i = 0; i < 3; ++i) {
        int low = corners[i], high = corners[(i + 1) % 3];
        if (heights.is_lower(high, low)) std::swap(low, high);
        has_lower |= std::uint64_t{1} << high;
        has_higher |= std::uint64_t{1} << low;
      }
    }
    const int minima = std::popcount(has_higher & ~has_lower);
    const int maxima = std::popcount(has_lower & ~has_higher);
    for (std::size_t k = t.order; k < orders; ++k) {
      best.minima[k] = std::min(best.minima[k], minima);
      best.maxima[k] = std::min(best.maxima[k], maxima);
      best.extrema[k] = std::min(best.extrema[k], minima + maxima);
    }
  }
  return best;
}

}  // namespace oracle
