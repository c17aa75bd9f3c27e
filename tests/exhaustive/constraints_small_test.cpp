// hodt::triangulate with constraints against the enumeration of all triangulations that have them:
// breaklines, outlines with holes and islands, and triangles that go as an edge is too long.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "../support/measures_by_definition.h"
#include "constrained.h"
#include "constraint_shapes.h"
#include "pipeline_check.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"
#include "hodt/pipeline/constrain.h"

namespace exhaustive {
namespace {

using hodt::Aggregate;
using hodt::Direction;
using hodt::EdgeMeasure;
using hodt::Method;
using hodt::Objective;
using hodt::TriangleMeasure;
using oracle::Constrained;
using oracle::ConstrainedCatalogue;
using oracle::Domain;
using oracle::Edge;
using oracle::edge_of;
using oracle::Instance;
using oracle::Triangle;
using oracle::Triangles;
using support::distance;
using support::Place;
using support::Real;

std::array<Edge, 3> sides_of(const Triangle& t) {
  return {edge_of(t[0], t[1]), edge_of(t[1], t[2]), edge_of(t[2], t[0])};
}

// ---- What is asked for, and what the definitions make of it ----

struct Question {
  std::vector<Edge> edges;  // breaklines
  std::optional<Domain> domain;
  double max_edge = std::numeric_limits<double>::infinity();
};

double length(const Instance& instance, const Edge& e) {
  const auto& [ax, ay] = instance.points()[e[0]];
  const auto& [bx, by] = instance.points()[e[1]];
  return std::hypot(ax - bx, ay - by);
}

/// Of the triangles inside those that stay: from outside in, any that has a long edge at the
/// border.
Triangles without_long(const Constrained& constrained, Triangles inside, double max_edge) {
  for (;;) {
    std::map<Edge, int> sides;
    for (const Triangle& t : inside)
      for (const Edge& e : sides_of(t)) ++sides[e];
    const auto goes = [&](const Triangle& t) {
      return std::ranges::any_of(sides_of(t), [&](const Edge& e) {
        return sides[e] == 1 && !constrained.is_constraint(e[0], e[1]) &&
               length(constrained.instance(), e) > max_edge;
      });
    };
    if (std::erase_if(inside, goes) == 0) return inside;
  }
}

/// The definitions' answer.
class Known {
 public:
  Known(const Instance& instance, const Question& question)
      : given(instance, all_edges(question)),
        whole(given.delaunay()),
        kept(kept_of(question)),
        bounded(oracle::domain_of(kept, {})),
        constrained(instance, with(given.edges(), bounded.edges)) {
    std::set<Edge> sides;
    std::set<int> corners;
    for (const Triangle& t : kept) {
      for (const Edge& e : sides_of(t)) sides.insert(e);
      corners.insert(t.begin(), t.end());
    }
    used.assign(corners.begin(), corners.end());
    report.walls = std::size_t(
        std::ranges::count_if(given.edges(), [&](const Edge& e) { return sides.contains(e); }));
    report.triangles_outside = whole.size() - inside_.size();
    report.triangles_too_long = inside_.size() - kept.size();
    report.unused_points = std::size_t(instance.size()) - used.size();
  }

 private:
  static std::vector<Edge> with(std::vector<Edge> edges, const std::vector<Edge>& more) {
    edges.insert(edges.end(), more.begin(), more.end());
    return edges;
  }
  static std::vector<Edge> all_edges(const Question& question) {
    return question.domain ? with(question.edges, question.domain->edges) : question.edges;
  }
  Triangles kept_of(const Question& question) {
    inside_ = whole;
    if (question.domain)
      std::erase_if(inside_, [&](const Triangle& t) {
        return !oracle::is_in_domain(given.instance(), question.domain->rings, t);
      });
    return without_long(given, inside_, question.max_edge);
  }
  Triangles inside_;

 public:
  const Constrained given;
  const Triangles whole, kept;
  const Domain bounded;  // by what is kept
  const Constrained constrained;
  std::vector<int> used;  // points
  hodt::ConstraintReport report;
};

/// The same constraints as a user may give them: in any order and direction, twice, of no length,
/// in one piece where they pass through points.
hodt::Constraints disguised(const Instance& instance, const Question& question,
                            families::Random& random) {
  hodt::Constraints constraints;
  const auto add = [&](std::vector<hodt::Constraints::Edge>& to, int u, int v) {
    if (random.integer(0, 1)) std::swap(u, v);
    to.push_back({hodt::Index(u), hodt::Index(v)});
  };
  for (const auto& [u, v] : question.edges) {
    for (int copies = random.integer(1, 4) / 3; copies >= 0; --copies) add(constraints.edges, u, v);
    if (random.integer(0, 5) == 0) add(constraints.edges, u, u);
    for (const auto& [a, b] : question.edges) {  // the two as one piece
      const int w = a == v ? b : b == v ? a : -1;
      if (w < 0 || w == u || instance.orient(u, v, w) != 0) continue;
      const auto& p = instance.points();
      if ((p[v] > p[u]) == (p[w] > p[v])) add(constraints.edges, u, w);
    }
  }
  if (question.domain)
    for (const auto& [u, v] : question.domain->edges)
      for (int copies = random.integer(0, 3) ? 1 : 3; copies > 0; --copies)
        add(constraints.boundary, u, v);
  random.shuffle(constraints.edges);
  random.shuffle(constraints.boundary);
  constraints.max_edge = question.max_edge;
  return constraints;
}

Question random_question(const Instance& instance, families::Random& random) {
  Question question;
  const int kind = random.integer(0, 5);
  if (kind >= 2 && kind <= 4) {
    question.domain = oracle::random_domain(instance, random);
    if (question.domain->inside.empty()) question.domain.reset();
  }
  if (kind <= 2) {
    const auto bounds = question.domain ? question.domain->edges : std::vector<Edge>();
    auto all = bounds;
    for (const auto& [u, v] : oracle::random_edges(instance, random.bits()))
      if (oracle::fits(instance, all, u, v)) {
        all.push_back({u, v});
        question.edges.push_back({u, v});
      }
  }
  if (kind >= 4) {
    const Known known(instance, question);
    const Triangle& t = known.kept[random.bits() % known.kept.size()];
    question.max_edge = length(instance, sides_of(t)[std::size_t(random.integer(0, 2))]);
  }
  return question;
}

// ---- The value of a triangulation ----

class Values {
 public:
  explicit Values(const Instance& instance) : instance_(instance) {
    for (int v = 0; v < instance.size(); ++v) {
      const auto& [x, y] = instance.points()[v];
      places_.push_back({x, y, instance.heights()[v]});
    }
  }
  Real of(const Objective& objective, const Triangles& triangles) const {
    if (objective.kind == Objective::measured) return measured(objective, triangles);
    return counted(objective, triangles);
  }

 private:
  Real measured(const Objective& objective, const Triangles& triangles) const {
    std::vector<Real> values;
    std::map<Edge, int> apex;  // by directed edges
    const bool is_total_length = hodt::is_total_length(objective);
    for (const auto& [a, b, c] : triangles) {
      apex[{a, b}] = c, apex[{b, c}] = a, apex[{c, a}] = b;
      if (!hodt::is_of_edges(objective) && !is_total_length)
        values.push_back(support::measure_by_definition(
            std::get<TriangleMeasure>(objective.measure).kind, objective.aggregate, places_[a],
            places_[b], places_[c]));
    }
    for (const auto& [e, l] : apex) {
      const auto other = apex.find({e[1], e[0]});
      const bool is_inner = other != apex.end();
      if (is_inner && e[0] > e[1]) continue;
      const Place &a = places_[e[0]], &b = places_[e[1]];
      if (is_total_length) values.push_back(distance(a, b));
      if (hodt::is_of_edges(objective) && is_inner)
        values.push_back(
            support::measure_by_definition(std::get<EdgeMeasure>(objective.measure).kind, a, b,
                                           places_[l], places_[other->second]));
    }
    if (values.empty()) return 0;
    if (objective.aggregate == Aggregate::max) return *std::ranges::max_element(values);
    if (objective.aggregate == Aggregate::min) return *std::ranges::min_element(values);
    return std::accumulate(values.begin(), values.end(), Real(0));
  }

  Real counted(const Objective& objective, const Triangles& triangles) const {
    std::map<int, std::set<int>> neighbours;
    for (const Triangle& t : triangles)
      for (int i = 0; i < 3; ++i) neighbours[t[i]].insert({t[(i + 1) % 3], t[(i + 2) % 3]});
    int count = 0;
    for (const auto& [v, around] : neighbours) {
      const auto is_lower = [&, v = v](int w) { return instance_.is_lower(w, v); };
      if (objective == Objective::min_max_degree) count = std::max(count, int(around.size()));
      if (hodt::counts_minima(objective)) count += std::ranges::none_of(around, is_lower);
      if (hodt::counts_maxima(objective)) count += std::ranges::all_of(around, is_lower);
    }
    return count;
  }

  const Instance& instance_;
  std::vector<Place> places_;
};

// ---- One run ----

struct Job {
  Objective objective;
  Method method;
  int k;

  std::string text() const {
    return hodt::name_of(objective) + " method " + std::to_string(int(method)) + " k " +
           std::to_string(k);
  }
};

bool same_bytes(const hodt::TriangulateResult& a, const hodt::TriangulateResult& b) {
  const auto values = [](const hodt::TriangulateResult& r) {
    const hodt::Value v = r.report.value.value_or(hodt::Value());
    return std::tuple(v.delaunay, v.result, v.bound, v.optimal);
  };
  return a.tin.triangles == b.tin.triangles && a.tin.points.xy == b.tin.points.xy &&
         values(a) == values(b) && a.report.order_histogram == b.report.order_histogram;
}

std::string why_not_mesh(const Known& known, const ConstrainedCatalogue& catalogue,
                         const hodt::TriangulateResult& result, const Triangles& triangles, int k) {
  const Instance& instance = known.given.instance();
  hodt::PointSet points;
  for (const int v : known.used) {
    points.xy.push_back({instance.points()[v].first, instance.points()[v].second});
    points.z.push_back(instance.heights()[v]);
  }
  if (result.tin.points.xy != points.xy || result.tin.points.z != points.z) return "other points";
  const auto at =
      std::ranges::find(catalogue.triangulations(), triangles, &oracle::Triangulation::triangles);
  if (at == catalogue.triangulations().end())
    return "no triangulation of the domain with the edges";
  if (at->order > k) return "of too high an order";
  std::vector<std::size_t> histogram;
  for (const Triangle& t : triangles) {
    const std::size_t order = known.constrained.triangle_order(t);
    histogram.resize(std::max(histogram.size(), order + 1));
    ++histogram[order];
  }
  const hodt::Report& report = result.report;
  if (report.order_histogram != histogram) return "report.order_histogram";
  if (int(report.order) != at->order) return "report.order";
  if (report.triangles != triangles.size()) return "report.triangles";
  if (report.points != std::size_t(instance.size()) || report.duplicates) return "report.points";
  if (report.constraints.walls != known.report.walls) return "report.constraints.walls";
  if (report.constraints.triangles_outside != known.report.triangles_outside)
    return "triangles_outside";
  if (report.constraints.triangles_too_long != known.report.triangles_too_long)
    return "triangles_too_long";
  if (report.constraints.unused_points != known.report.unused_points) return "unused_points";
  const auto extrema_of = [&](const Triangles& t) {
    return instance.count_extrema(t, oracle::boundary_vertices(instance, t));
  };
  if (!same(extrema_of(known.kept), report.extrema_delaunay)) return "report.extrema_delaunay";
  if (!same(extrema_of(triangles), report.extrema_result)) return "report.extrema_result";
  return "";
}

/// Whether more than two edges of the boundary meet in a point. Its sides are optimised apart.
bool touches_itself(const Triangles& triangles) {
  std::map<Edge, int> sides;
  for (const Triangle& t : triangles)
    for (const Edge& e : sides_of(t)) ++sides[e];
  std::map<int, int> ends;
  for (const auto& [e, count] : sides)
    if (count == 1) ++ends[e[0]], ++ends[e[1]];
  return std::ranges::any_of(ends, [](const auto& end) { return end.second > 2; });
}

std::string why_not_value(const Known& known, const ConstrainedCatalogue& catalogue,
                          const hodt::TriangulateResult& result, const Triangles& triangles,
                          const Job& run) {
  if (run.objective == Objective::none) return result.report.value ? "a value of none" : "";
  if (!result.report.value) return "no value";
  const hodt::Value& v = *result.report.value;
  const Values values(known.given.instance());
  const Real sign = run.objective.direction == Direction::minimize ? 1 : -1;
  Real best = std::numeric_limits<Real>::infinity();
  for (const auto& t : catalogue.triangulations())
    if (t.order <= run.k) best = std::min(best, sign * values.of(run.objective, t.triangles));
  const auto slack = [](Real value) { return 1e-9L * (1 + std::fabs(value)); };
  const auto is = [&](double said, Real value) { return std::fabs(said - value) <= slack(value); };
  const auto text = [&](const std::string& why) {
    return why + ": delaunay " + std::to_string(v.delaunay) + " result " +
           std::to_string(v.result) + " bound " + std::to_string(v.bound) +
           (v.optimal ? " optimal" : "") + ", optimum " + std::to_string(double(sign * best)) +
           ", value " + std::to_string(double(values.of(run.objective, triangles)));
  };
  if (!is(v.result, values.of(run.objective, triangles))) return text("another value");
  if (!is(v.delaunay, values.of(run.objective, known.kept))) return text("another Delaunay value");
  if (sign * v.result > sign * v.delaunay) return text("worse than Delaunay");
  if (sign * v.bound > sign * v.result) return text("a bound on the wrong side");
  if (sign * v.bound > best + slack(best)) return text("a bound that the optimum passes");
  if (v.optimal && !is(v.result, sign * best)) return text("not optimal, but said to be");
  const bool counts_vertices = run.objective.kind != Objective::measured;
  if (run.k <= 1 && !v.optimal && !(counts_vertices && touches_itself(known.kept)))
    return text("order 1 is solved always");
  return "";
}

std::string why_not_told(const Known& known, const hodt::Tin& tin) {
  const auto corners = [&](const Triangle& t) {
    return Triangle{known.used[std::size_t(t[0])], known.used[std::size_t(t[1])],
                    known.used[std::size_t(t[2])]};
  };
  return exhaustive::why_not_told(
      tin, true, [&](const Triangle& t) { return known.constrained.triangle_order(corners(t)); },
      [&](const Triangle& t) {
        const Triangles one = known.given.instance().canonical({corners(t)});
        return std::ranges::count(known.kept, one.front()) > 0;
      });
}

/// All that is said of a result, on one thread and on two.
std::string why_wrong(const Known& known, const ConstrainedCatalogue& catalogue,
                      const hodt::Constraints& constraints, const Job& run) {
  const Instance& instance = known.given.instance();
  hodt::TriangulateOptions options{
      .order = hodt::Index(run.k), .objective = run.objective, .method = run.method};
  const auto on_threads = [&](std::size_t threads) {
    const hodt::ThreadLimit limit(threads);
    options.tell_orders = threads == 2;
    return hodt::triangulate(to_point_set(instance), options, constraints);
  };
  const auto result = on_threads(2);
  if (!same_bytes(result, on_threads(1))) return "depends on threads";
  if (result.report.constraints.edges != constraints.edges.size() + constraints.boundary.size())
    return "report.constraints.edges";
  Triangles triangles;
  for (const auto& [a, b, c] : result.tin.triangles) {
    for (const hodt::Index v : {a, b, c})
      if (v >= known.used.size()) return "no such vertex";
    triangles.push_back({known.used[a], known.used[b], known.used[c]});
    if (instance.orient(known.used[a], known.used[b], known.used[c]) <= 0) return "clockwise";
  }
  if (auto why = why_not_told(known, result.tin); !why.empty()) return why;
  triangles = instance.canonical(triangles);
  if (auto why = why_not_mesh(known, catalogue, result, triangles, run.k); !why.empty()) return why;
  return why_not_value(known, catalogue, result, triangles, run);
}

std::string describe(const Instance& instance, const hodt::Constraints& constraints) {
  std::string text = to_source(instance);
  const auto add = [&](const char* what, const auto& edges) {
    text += what;
    for (const auto& [u, v] : edges) text += ' ' + std::to_string(u) + '-' + std::to_string(v);
  };
  add(" edges", constraints.edges);
  add(" boundary", constraints.boundary);
  return text + " max_edge " + std::to_string(constraints.max_edge);
}

/// Families whose measures no rounding spoils.
bool is_tame(const families::Family& family) {
  static const std::set<std::string> tame{"random_square",
                                          "convex_parabola",
                                          "lattice_4x4_subset",
                                          "lattice_5x5_subset",
                                          "lattice_8x8_subset",
                                          "ring_25",
                                          "ring_1105_with_centre",
                                          "concentric_rings",
                                          "collinear_inside",
                                          "fan",
                                          "outline",
                                          "two_lines",
                                          "collinear_on_hull",
                                          "ring_within"};
  return tame.contains(family.name);
}

Job random_run(const families::Family& family, int n, families::Random& random) {
  constexpr std::array kMethods{Method::automatic, Method::flip, Method::exact, Method::greedy};
  Job run{Objective::none, kMethods[std::size_t(random.integer(0, 2))], random.integer(0, 5)};
  if (run.k == 5) run.k = random.integer(0, 1) ? n : 1000000;
  const int what = random.integer(0, is_tame(family) ? 22 : 4);
  const auto direction = Direction(random.integer(0, 1));
  const auto aggregate = Aggregate(random.integer(0, 2));
  if (what >= 5 && what < 17) {
    run.objective = {direction, aggregate, TriangleMeasure(TriangleMeasure::Kind(what % 8))};
  } else if (what >= 17) {
    run.objective = {direction, aggregate, EdgeMeasure(EdgeMeasure::Kind(what % 3))};
  } else {
    run.objective = Objective::Kind(what);
    if (hodt::counts_extrema(run.objective))
      run.method = kMethods[std::size_t(random.integer(0, 3))];
  }
  return run;
}

class ConstrainedSmall : public testing::TestWithParam<families::Family> {};

TEST_P(ConstrainedSmall, every_objective_is_as_the_definitions_say) {
  constexpr int kRuns = 12;
  for (int n = 4; n <= 8; ++n) {
    for (int seed = 0; seed < (slow() ? 200 : 10); ++seed) {
      families::Random random(1000 * n + seed);
      Instance instance(GetParam().make(n, seed));
      const auto& heights = families::all_heights();
      instance.set_heights(
          heights[random.bits() % heights.size()].make(instance.points(), random.bits()));
      const Question question = random_question(instance, random);
      const hodt::Constraints constraints = disguised(instance, question, random);
      if (constraints.empty()) continue;
      const Known known(instance, question);
      if (known.kept.empty()) {
        EXPECT_THROW(hodt::triangulate(to_point_set(instance), {}, constraints), hodt::InputError);
        continue;
      }
      const ConstrainedCatalogue catalogue(known.constrained, known.bounded.rings);
      for (int i = 0; i < kRuns; ++i) {
        const Job run = random_run(GetParam(), instance.size(), random);
        ASSERT_EQ(why_wrong(known, catalogue, constraints, run), "")
            << run.text() << ' ' << describe(instance, constraints);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Families, ConstrainedSmall,
                         testing::ValuesIn(oracle::families_for_constraints()),
                         [](const auto& each) { return each.param.name; });

// ---- What is no constraint ----

const hodt::PointSet kSquare{{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 1}, {2, 6}}, {}};
const hodt::TriangulateOptions kNone{.objective = Objective::none};

TEST(WrongConstraints, crossing_edges_are_named_with_the_place) {
  hodt::Constraints constraints;
  constraints.edges = {{4, 1}, {0, 2}};
  constraints.boundary = {{1, 3}, {3, 0}, {0, 1}};
  try {
    hodt::triangulate(kSquare, kNone, constraints);
    FAIL() << "not refused";
  } catch (const hodt::CrossingError& error) {
    EXPECT_EQ(error.crossings(), (std::vector<hodt::CrossingEdges>{{1, 2}}));
    const std::string what = error.what();
    for (const char* part : {"rows 0 and 2", "rows 1 and 3", "x 2,", "y 2"})
      EXPECT_NE(what.find(part), std::string::npos) << what;
  }
}

TEST(WrongConstraints, a_row_that_is_not_there) {
  hodt::Constraints constraints;
  constraints.edges = {{0, 6}};
  EXPECT_THROW(hodt::triangulate(kSquare, kNone, constraints), hodt::ParameterError);
  constraints = {};
  constraints.boundary = {{6, 0}};
  EXPECT_THROW(hodt::triangulate(kSquare, kNone, constraints), hodt::ParameterError);
}

TEST(WrongConstraints, a_boundary_that_is_open_or_has_no_triangle) {
  hodt::Constraints constraints;
  constraints.boundary = {{0, 1}, {1, 2}, {2, 3}};
  EXPECT_THROW(hodt::triangulate(kSquare, kNone, constraints), hodt::InputError);
  constraints.boundary = {{0, 1}, {1, 2}, {2, 0}, {0, 1}, {2, 1}, {2, 0}};
  EXPECT_THROW(hodt::triangulate(kSquare, kNone, constraints), hodt::InputError);
  constraints.boundary = {};
  constraints.max_edge = 0.5;
  EXPECT_THROW(hodt::triangulate(kSquare, kNone, constraints), hodt::InputError);
}

/// A line that ends at a row which was dropped ends at the one that stays.
TEST(WrongConstraints, a_duplicate_stands_for_the_point_at_its_place) {
  hodt::PointSet points = kSquare;
  points.xy.push_back(points.xy[3]);
  hodt::Constraints constraints;
  constraints.edges = {{6, 1}};
  const auto result = hodt::triangulate(points, kNone, constraints);
  EXPECT_EQ(result.report.constraints.walls, 1u);
  EXPECT_EQ(result.report.duplicates, 1u);
}

}  // namespace
}  // namespace exhaustive
