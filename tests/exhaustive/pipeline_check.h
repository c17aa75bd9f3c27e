// One run of hodt::triangulate against everything that the oracle knows about it.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <optional>
#include <sstream>
#include <string>

#include "families.h"
#include "oracle.h"

#include "hodt/pipeline.h"

namespace exhaustive {

/// Larger sweeps, for those who have the time.
inline bool slow() {
  return std::getenv("HODT_SLOW") != nullptr;
}

inline hodt::PointSet to_point_set(const oracle::Instance& instance) {
  hodt::PointSet points;
  for (const auto& [x, y] : instance.points()) points.xy.push_back({x, y});
  points.z = instance.heights();
  return points;
}

inline oracle::Triangles to_oracle(const hodt::Tin& tin) {
  oracle::Triangles triangles;
  for (const auto& [a, b, c] : tin.triangles) {
    triangles.push_back({static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)});
  }
  return triangles;
}

/// The points as C++ source, so that a failure can become a test of its own.
inline std::string to_source(const oracle::Instance& instance) {
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "points {";
  for (const auto& [x, y] : instance.points()) out << "{" << x << ", " << y << "}, ";
  out << "} heights {";
  for (const double z : instance.heights()) out << z << ", ";
  out << "}";
  return out.str();
}

/// What the oracle knows about the value: exact where everything could be enumerated.
struct Expected {
  std::optional<int> optimum;
};

inline bool is_minimum(hodt::Objective o) {
  return o == hodt::Objective::min_local_minima;
}
inline bool is_maximum(hodt::Objective o) {
  return o == hodt::Objective::min_local_maxima;
}

inline int value_of(hodt::Objective objective, const oracle::ExtremaCount& count) {
  if (is_minimum(objective)) return count.minima.total();
  if (is_maximum(objective)) return count.maxima.total();
  return count.minima.total() + count.maxima.total();
}

inline int optimum_of(hodt::Objective objective, const oracle::Optima& optima, int k) {
  if (is_minimum(objective)) return oracle::Optima::at(optima.minima, k);
  if (is_maximum(objective)) return oracle::Optima::at(optima.maxima, k);
  return oracle::Optima::at(optima.extrema, k);
}

inline bool same(const oracle::SplitCount& a, const hodt::SplitCount& b) {
  return a.interior == static_cast<int>(b.interior) && a.boundary == static_cast<int>(b.boundary);
}

inline bool same(const oracle::ExtremaCount& a, const std::optional<hodt::ExtremaCount>& b) {
  return b && same(a.minima, b->minima) && same(a.maxima, b->maxima) && same(a.pits, b->pits);
}

/// What the TIN says of its triangles, if it says anything, against their orders by definition, and
/// against the Delaunay triangulation.
template <class OrderOf, class IsDelaunay>
std::string why_not_told(const hodt::Tin& tin, bool asked, const OrderOf& order_of,
                         const IsDelaunay& is_delaunay) {
  if (!asked) return tin.order.empty() ? "" : "orders that nobody asked for";
  if (tin.order.size() != tin.triangles.size()) return "not every order is told";
  for (std::size_t t = 0; t < tin.triangles.size(); ++t) {
    const auto& [a, b, c] = tin.triangles[t];
    const oracle::Triangle corners{static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)};
    if (static_cast<int>(tin.order[t]) != order_of(corners)) return "another order";
    if (tin.is_changed(t) == is_delaunay(corners)) return "changed, or not";
  }
  return "";
}

inline std::string why_not_told(const oracle::Instance& instance, const hodt::Tin& tin,
                                bool asked) {
  const oracle::Triangles delaunay = instance.delaunay();
  return why_not_told(
      tin, asked,
      [&](const oracle::Triangle& t) {
        return static_cast<int>(instance.triangle_order(t[0], t[1], t[2]));
      },
      [&](const oracle::Triangle& t) {
        return std::ranges::count(delaunay, instance.canonical({t}).front()) > 0;
      });
}

/// The triangles: a triangulation of all the points, of order <= k, counter-clockwise, and
/// described truly. Empty if so, else what is wrong.
inline std::string why_not_k_od(const oracle::Instance& instance,
                                const hodt::TriangulateResult& result, int k) {
  const hodt::PointSet points = to_point_set(instance);
  if (result.tin.points.xy != points.xy || result.tin.points.z != points.z) return "other points";
  const oracle::Triangles triangles = to_oracle(result.tin);
  if (const std::string why = instance.why_not_triangulation(triangles); !why.empty()) return why;
  std::vector<std::size_t> histogram;
  for (const auto& [a, b, c] : triangles) {
    if (instance.orient(a, b, c) < 0) return "a clockwise triangle";
    const std::size_t order = instance.triangle_order(a, b, c);
    if (histogram.size() <= order) histogram.resize(order + 1);
    ++histogram[order];
  }
  if (instance.order(triangles) > k) return "a triangle of too high an order";
  if (static_cast<int>(result.report.order) != instance.order(triangles)) return "report.order";
  if (result.report.order_histogram != histogram) return "report.order_histogram";
  if (result.report.triangles != triangles.size()) return "report.triangles";
  if (result.report.points != points.size() || result.report.duplicates) return "report.points";
  return "";
}

/// The numbers of the report against a recount from the triangles, and against the optimum.
inline std::string why_not_value(const oracle::Instance& instance,
                                 const oracle::Triangles& delaunay,
                                 const hodt::TriangulateResult& result, hodt::Objective objective,
                                 int k, const Expected& expected) {
  const hodt::Report& report = result.report;
  const auto before = instance.count_extrema(delaunay);
  const auto after = instance.count_extrema(to_oracle(result.tin));
  if (!same(before, report.extrema_delaunay)) return "report.extrema_delaunay";
  if (!same(after, report.extrema_result)) return "report.extrema_result";
  if (objective == hodt::Objective::none) return report.value ? "a value of no objective" : "";
  if (!report.value) return "no value";
  const hodt::Value& value = *report.value;
  if (value.delaunay != value_of(objective, before)) return "value.delaunay is not a recount";
  if (value.result != value_of(objective, after)) return "value.result is not a recount";
  if (value.result > value.delaunay) return "worse than Delaunay";
  if (!(value.bound <= value.result)) return "the bound is above the result";
  if (value.optimal && value.bound != value.result) return "optimal, but the bound is lower";
  if (k == 0 && !value.optimal) return "Delaunay is the only choice, and not reported optimal";
  if (!expected.optimum) return "";
  if (value.bound > *expected.optimum) return "the bound is above the optimum";
  if (value.result < *expected.optimum) return "better than the optimum: the oracle errs";
  if (value.optimal && value.result != *expected.optimum) return "not optimal, but reported so";
  if (k <= 1 && value.result != *expected.optimum) return "first order, but not optimal";
  if (k <= 1 && !value.optimal) return "first order, but not reported optimal";
  return "";
}

}  // namespace exhaustive
