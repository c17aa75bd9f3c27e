// Every objective and method on small lattices, against all triangulations.
//
// Bytes become at most eight points of a small lattice with heights, an order, a method and an
// objective. The lattice is scaled by a power of two, from the smallest doubles to the largest, and
// may be moved far away; neither changes a difference of coordinates, so what everything measures
// is known from the lattice alone. Whatever hodt says is compared with that: values, bounds,
// orders, what is said to be the optimum, and which values no double can hold.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "../oracle/oracle.h"
#include "../support/measures_by_definition.h"

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"
#include "hodt/pipeline.h"

namespace {

using support::Real;

/// Choices read from the input; zeros at its end.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : rest_(data, size) {}
  int next(int count) {
    if (rest_.empty()) return 0;
    const int value = rest_.front() % count;
    rest_ = rest_.subspan(1);
    return value;
  }

 private:
  std::span<const std::uint8_t> rest_;
};

struct Corner {
  int x, y, z;
  auto place() const { return std::pair(x, y); }
};

using hodt::Aggregate;
using hodt::Direction;
using hodt::EdgeMeasure;
using hodt::Objective;
using hodt::TriangleMeasure;

// Measures of one's own, of the first degree and of none.
const hodt::OwnTriangleMeasure kPerimeter{"perimeter",
                                          [](const auto& a, const auto& b, const auto& c) {
                                            const auto side = [](const auto& p, const auto& q) {
                                              return std::fabs(p.x - q.x) + std::fabs(p.y - q.y);
                                            };
                                            return side(a, b) + side(b, c) + side(c, a);
                                          }};
const hodt::OwnEdgeMeasure kRise{
    "rise",
    [](const auto& a, const auto& b, const auto& left, const auto& right) {
      return std::fabs(a.z - b.z) + 2 * std::fabs(left.z - right.z);
    },
    true};

struct Case {
  std::vector<Corner> rows;
  int scale = 0;  // a power of two
  double offset_x = 0, offset_y = 0;
  hodt::Index k = 0;
  Objective objective;
  hodt::Method method = hodt::Method::automatic;

  explicit Case(Bytes bytes);
  hodt::PointSet points() const;
  std::string text() const;
};

Case::Case(Bytes bytes) {
  const int n = 3 + bytes.next(6), side = 3 + bytes.next(3), heights = 1 + bytes.next(6);
  for (int i = 0; i < n; ++i) {
    const int x = bytes.next(side), y = bytes.next(side);
    rows.push_back({x, y, bytes.next(heights)});
  }
  constexpr std::array<int, 16> kScales = {0,    0,   0,    0,   1,    -3,   40,    90,
                                           -300, 300, -540, 520, 1000, 1020, -1021, -1074};
  scale = kScales[std::size_t(bytes.next(16))] + (bytes.next(4) == 0 ? bytes.next(40) - 20 : 0);
  scale = std::clamp(scale, -1074, 1020);
  constexpr std::array<double, 4> kOffsets = {0, 0, -3, 0x1p40};
  offset_x = kOffsets[std::size_t(bytes.next(4))];
  offset_y = kOffsets[std::size_t(bytes.next(4))];
  if (scale > 970) offset_x = std::min(offset_x, 0.0), offset_y = std::min(offset_y, 0.0);
  k = bytes.next(8) == 0 ? std::numeric_limits<hodt::Index>::max() - hodt::Index(bytes.next(3))
                         : hodt::Index(bytes.next(n + 1));
  constexpr std::array kMethods = {hodt::Method::automatic, hodt::Method::flip,
                                   hodt::Method::exact};
  method = kMethods[std::size_t(bytes.next(3))];
  const auto direction = Direction(bytes.next(2));
  const auto aggregate = Aggregate(bytes.next(3));
  const int what = bytes.next(18);
  if (what < 9) {
    objective = {direction, aggregate,
                 what < 8 ? TriangleMeasure(TriangleMeasure::Kind(what)) : kPerimeter};
  } else if (what < 13) {
    objective = {direction, aggregate,
                 what < 12 ? EdgeMeasure(EdgeMeasure::Kind(what - 9)) : EdgeMeasure(kRise)};
  } else {
    objective = Objective::Kind(what - 13);
    if (hodt::counts_extrema(objective) && bytes.next(3) == 0) method = hodt::Method::greedy;
  }
}

hodt::PointSet Case::points() const {
  hodt::PointSet set;
  for (const auto& [x, y, z] : rows) {
    set.xy.push_back({std::ldexp(x + offset_x, scale), std::ldexp(y + offset_y, scale)});
    set.z.push_back(std::ldexp(z, scale));
  }
  return set;
}

std::string Case::text() const {
  std::string text = hodt::name_of(objective) + " k = " + std::to_string(k) + " method " +
                     std::to_string(int(method)) + " times 2^" + std::to_string(scale) +
                     " moved by " + std::to_string(offset_x) + ' ' + std::to_string(offset_y) + ':';
  for (const auto& [x, y, z] : rows)
    text += ' ' + std::to_string(x) + ',' + std::to_string(y) + ',' + std::to_string(z);
  return text;
}

// ---- What the lattice's triangulations measure. ----

using support::Place;

Place place(const Corner& c) {
  return {Real(c.x), Real(c.y), Real(c.z)};
}

Real side(const Corner& a, const Corner& b) {
  return support::distance(place(a), place(b));
}

Real measure_of(const Objective& objective, const Corner& a, const Corner& b, const Corner& c) {
  const TriangleMeasure measure = std::get<TriangleMeasure>(objective.measure);
  if (measure.kind == TriangleMeasure::own) {
    const auto steps = [](const Corner& p, const Corner& q) {
      return std::abs(p.x - q.x) + std::abs(p.y - q.y);
    };
    return steps(a, b) + steps(b, c) + steps(c, a);
  }
  return support::measure_by_definition(measure.kind, objective.aggregate, place(a), place(b),
                                        place(c));
}

Real measure_across(const Objective& objective, const Corner& a, const Corner& b, const Corner& l,
                    const Corner& r) {
  const EdgeMeasure measure = std::get<EdgeMeasure>(objective.measure);
  if (measure.kind == EdgeMeasure::own) return std::abs(a.z - b.z) + 2 * std::abs(l.z - r.z);
  return support::measure_by_definition(measure.kind, place(a), place(b), place(l), place(r));
}

/// Of what power of the unit of length a measure is.
int degree_of(const Objective& objective) {
  if (hodt::is_of_edges(objective)) {
    const auto kind = std::get<EdgeMeasure>(objective.measure).kind;
    return kind == EdgeMeasure::wabn || kind == EdgeMeasure::own ? 1 : 0;
  }
  switch (std::get<TriangleMeasure>(objective.measure).kind) {
    case TriangleMeasure::area:
    case TriangleMeasure::flat_area:
      return 2;
    case TriangleMeasure::angle:
    case TriangleMeasure::small_angle:
      return 0;
    default:
      return 1;
  }
}

class Lattice {
 public:
  Lattice(const Case& c, std::vector<Corner> vertices) : case_(c), vertices_(std::move(vertices)) {}

  oracle::Instance instance() const {
    oracle::Points points;
    oracle::Heights z;
    for (const auto& [x, y, height] : vertices_) {
      points.emplace_back(x, y);
      z.push_back(height);
    }
    return oracle::Instance(points, z);
  }

  Real value(const oracle::Instance& instance, const oracle::Triangles& triangles) const {
    const Objective& objective = case_.objective;
    if (objective == Objective::min_max_degree) return largest_degree(triangles);
    if (objective.kind == Objective::measured) return measured(triangles);
    const oracle::ExtremaCount count = instance.count_extrema(triangles);
    return (hodt::counts_minima(objective) ? count.minima.total() : 0) +
           (hodt::counts_maxima(objective) ? count.maxima.total() : 0);
  }

 private:
  Real measured(const oracle::Triangles& triangles) const {
    const Objective& objective = case_.objective;
    std::vector<Real> values;
    std::map<std::pair<int, int>, int> apex;
    for (const auto& [a, b, c] : triangles) {
      apex[{a, b}] = c, apex[{b, c}] = a, apex[{c, a}] = b;
      if (!hodt::is_of_edges(objective))
        values.push_back(measure_of(objective, vertices_[a], vertices_[b], vertices_[c]));
    }
    for (const auto& [edge, l] : apex) {
      const auto& [a, b] = edge;
      const auto other = apex.find({b, a});
      if (hodt::is_total_length(objective) && other == apex.end())
        values.push_back(side(vertices_[a], vertices_[b]) / 2);
      if (hodt::is_of_edges(objective) && a < b && other != apex.end())
        values.push_back(measure_across(objective, vertices_[a], vertices_[b], vertices_[l],
                                        vertices_[other->second]));
    }
    if (values.empty()) return 0;
    if (objective.aggregate == Aggregate::max)
      return *std::max_element(values.begin(), values.end());
    if (objective.aggregate == Aggregate::min)
      return *std::min_element(values.begin(), values.end());
    Real sum = 0;
    for (const Real value : values) sum += value;
    return sum;
  }

  static Real largest_degree(const oracle::Triangles& triangles) {
    std::set<std::pair<int, int>> edges;
    for (const auto& [a, b, c] : triangles)
      for (const auto& [u, v] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
        edges.emplace(std::min(u, v), std::max(u, v));
    std::map<int, int> degree;
    for (const auto& [u, v] : edges) ++degree[u], ++degree[v];
    int largest = 0;
    for (const auto& [v, d] : degree) largest = std::max(largest, d);
    return largest;
  }

  const Case& case_;
  const std::vector<Corner> vertices_;
};

// ---- The comparison. ----

[[noreturn]] void fail(const Case& c, const std::string& why) {
  std::fprintf(stderr, "%s\n  %s\n", why.c_str(), c.text().c_str());
  std::abort();
}

/// The first row of each place with the lowest height stays, in the order of the rows.
std::vector<Corner> kept_rows(const std::vector<Corner>& rows) {
  std::vector<Corner> kept;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    bool stays = true;
    for (std::size_t j = 0; j < rows.size(); ++j)
      if (j != i && rows[j].place() == rows[i].place())
        stays &= rows[i].z < rows[j].z || (rows[i].z == rows[j].z && i < j);
    if (stays) kept.push_back(rows[i]);
  }
  return kept;
}

bool has_area(const std::vector<Corner>& rows) {
  for (const Corner& a : rows)
    for (const Corner& b : rows)
      for (const Corner& c : rows)
        if ((b.x - a.x) * (c.y - a.y) != (b.y - a.y) * (c.x - a.x)) return true;
  return false;
}

/// Some value may be out of a double's range. No measure of such lattices, nor the sum of all, is
/// further from its unit than 2^10, but for those that are 0.
bool may_be_out_of_range(const Case& c) {
  if (c.objective.kind != Objective::measured) return false;
  const int exponent = degree_of(c.objective) * c.scale;
  return exponent < -1012 || exponent > 1012;
}

std::optional<hodt::TriangulateResult> run(const Case& c) {
  try {
    return hodt::triangulate(c.points(),
                             {.order = c.k, .objective = c.objective, .method = c.method});
  } catch (const hodt::Error& error) {
    if (has_area(c.rows) && !may_be_out_of_range(c)) fail(c, error.what());
    return std::nullopt;
  }
}

bool same(const hodt::TriangulateResult& a, const hodt::TriangulateResult& b) {
  const auto values = [](const hodt::TriangulateResult& r) {
    const hodt::Value v = r.report.value.value_or(hodt::Value());
    return std::tuple(v.delaunay, v.result, v.bound, v.optimal);
  };
  return a.tin.triangles == b.tin.triangles && values(a) == values(b);
}

void check(const Case& c) {
  const std::optional<hodt::TriangulateResult> result = run(c);
  {
    const hodt::ThreadLimit limit(1);
    const std::optional<hodt::TriangulateResult> again = run(c);
    if (result.has_value() != again.has_value() || (result && !same(*result, *again)))
      fail(c, "depends on threads");
  }
  if (!result) return;
  const std::vector<Corner> kept = kept_rows(c.rows);
  const Lattice lattice(c, kept);
  const oracle::Instance instance = lattice.instance();
  if (result->tin.points.size() != kept.size()) fail(c, "other duplicates stay");
  oracle::Triangles triangles;
  for (const auto& [a, b, d] : result->tin.triangles) triangles.push_back({int(a), int(b), int(d)});
  triangles = instance.canonical(triangles);
  if (const std::string why = instance.why_not_triangulation(triangles); !why.empty())
    fail(c, "no triangulation: " + why);
  if (c.objective == Objective::none) return;
  const int most = int(std::min<hodt::Index>(c.k, 1000));
  const bool is_measured = c.objective.kind == Objective::measured;
  const Real unit = is_measured ? std::ldexp(Real(1), degree_of(c.objective) * c.scale) : 1;
  const Real sign = c.objective.direction == Direction::minimize ? 1 : -1;
  Real optimum = sign * std::numeric_limits<Real>::infinity(), delaunay = 0;
  bool is_of_order = false;
  oracle::for_each_triangulation(instance, most, [&](const oracle::Triangles& t, int order) {
    const Real value = lattice.value(instance, t);
    optimum = sign > 0 ? std::min(optimum, value) : std::max(optimum, value);
    if (order == 0) delaunay = value;
    is_of_order |= instance.canonical(t) == triangles;
  });
  if (!is_of_order) fail(c, "the result is of a larger order");

  const hodt::Value v = *result->report.value;
  const auto text = [&] {
    char line[400];
    std::snprintf(line, sizeof line, ": delaunay %.17g result %.17g bound %.17g %s, optimum %.17Lg",
                  v.delaunay, v.result, v.bound, v.optimal ? "optimal" : "", optimum * unit);
    return std::string(line);
  };
  for (const double value : {v.delaunay, v.result, v.bound})
    if (!std::isfinite(value) || std::signbit(value)) fail(c, "no such value" + text());
  if (sign * v.result > sign * v.delaunay) fail(c, "worse than Delaunay's" + text());
  if (sign * v.bound > sign * v.result) fail(c, "a bound on the wrong side" + text());
  // What rounding makes of single values: of gradients of the same plane, and of subnormal numbers.
  const Real least = hodt::is_of_edges(c.objective) ? 1e-12L * unit : 0;
  const auto slack = [&](Real value) {
    return 1e-14L * value * unit + least + 20 * Real(std::numeric_limits<double>::denorm_min());
  };
  const auto is = [&](double said, Real value) {
    return std::fabs(Real(said) - value * unit) <= slack(value);
  };
  if (!is(v.result, lattice.value(instance, triangles))) fail(c, "another value" + text());
  if (!is(v.delaunay, delaunay)) fail(c, "another value of Delaunay's" + text());
  if (sign * v.bound > sign * (optimum * unit) + slack(optimum))
    fail(c, "a bound that the optimum passes" + text());
  if (v.optimal && std::fabs(v.result - optimum * unit) > 1e-9L * optimum * unit + slack(optimum))
    fail(c, "not optimal" + text());
  if (c.k == 1 && !v.optimal) fail(c, "order 1 is solved always" + text());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  check(Case(Bytes(data, size)));
  return 0;
}
