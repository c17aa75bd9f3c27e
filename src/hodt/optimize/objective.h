// What a triangulation can be made best for, and by which method.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace hodt {

/// What is measured of a triangle, or of two triangles across an edge. All planar (x, y) but for
/// flat_area and those across edges; lengths and areas in units of the coordinates, angles in
/// degrees. measures.h and edge_measures.h have the functions.
enum class Measure : std::uint8_t {
  area,
  angle,        ///< the largest
  small_angle,  ///< the smallest
  circumradius,
  enclosing_radius,  ///< of the smallest enclosing circle
  inradius,
  length,     ///< of edges: a sum counts every edge once
  flat_area,  ///< the area, if all three heights are equal, else 0
  abn,        ///< the angle between the normals across an inner edge
  jnd,        ///< the jump of the normal derivative across an inner edge
  wabn,       ///< the planar length of an inner edge times its abn
};

inline bool is_of_edges(Measure measure) {
  return measure == Measure::abn || measure == Measure::jnd || measure == Measure::wabn;
}

enum class Aggregate : std::uint8_t { sum, max, min };
enum class Direction : std::uint8_t { minimize, maximize };

struct Objective {
  enum Kind : std::uint8_t {
    none,
    min_local_minima,
    min_local_maxima,
    min_local_extrema,
    min_max_degree,  ///< of vertices
    measured,        ///< the sum, largest or smallest value of a measure over all triangles
  };

  constexpr Objective(Kind k = none) : kind(k) {}  // NOLINT: a kind is an objective
  constexpr Objective(Direction d, Aggregate a, Measure m)
      : kind(measured), direction(d), aggregate(a), measure(m) {}
  friend bool operator==(const Objective&, const Objective&) = default;

  Kind kind;
  Direction direction = Direction::minimize;  // from here on: of kind measured
  Aggregate aggregate = Aggregate::sum;
  Measure measure = Measure::area;
};

enum class Method {
  automatic,  ///< the best there is, with limited work
  greedy,     ///< independent hulls (Theorem 8); for minima, maxima and extrema
  flip,       ///< flips that improve, as long as there are any
  exact,      ///< as automatic, but searching on until the best is proven, or far longer
};

/// The objective or method of that name on the command line ("min-local-minima",
/// "min-max-angle", "auto"). Throws ParameterError, naming the ones there are, for any other name.
Objective objective_from_name(std::string_view name);
Method method_from_name(std::string_view name);
std::string name_of(Objective objective);
/// The names of all measures, separated by commas.
std::string measure_names();

inline bool counts_minima(Objective objective) {
  return objective == Objective::min_local_minima || objective == Objective::min_local_extrema;
}
inline bool counts_maxima(Objective objective) {
  return objective == Objective::min_local_maxima || objective == Objective::min_local_extrema;
}
inline bool counts_extrema(Objective objective) {
  return counts_minima(objective) || counts_maxima(objective);
}
/// Throws ParameterError if the method is not one for the objective.
void check_method(Method method, Objective objective);

/// Throws ParameterError if the objective needs heights and there are none.
void check_heights(Objective objective, bool has_heights);

inline bool needs_heights(Objective objective) {
  return counts_extrema(objective) ||
         (objective.kind == Objective::measured &&
          (objective.measure == Measure::flat_area || is_of_edges(objective.measure)));
}

}  // namespace hodt
