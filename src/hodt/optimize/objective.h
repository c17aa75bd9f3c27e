// What a triangulation can be made best for, and by which method.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/optimize/own_measures.h"

namespace hodt {

/// What is measured of a triangle. All planar (x, y) but for flat_area and one's own; lengths and
/// areas in units of the coordinates, angles in degrees. measures.h has the functions.
struct TriangleMeasure {
  enum Kind : std::uint8_t {
    area,
    angle,        ///< the largest
    small_angle,  ///< the smallest
    circumradius,
    enclosing_radius,  ///< of the smallest enclosing circle
    inradius,
    length,     ///< of edges: a sum counts every edge once
    flat_area,  ///< the area, if all three heights are equal, else 0
    own,
  };

  constexpr TriangleMeasure(Kind k) : kind(k) {}  // NOLINT: a kind is a measure
  /// A view: `measure` must outlive all objectives with it.
  constexpr TriangleMeasure(const OwnTriangleMeasure& measure)  // NOLINT
      : kind(own), own_measure(&measure) {}
  TriangleMeasure(OwnTriangleMeasure&&) = delete;
  friend bool operator==(const TriangleMeasure&, const TriangleMeasure&) = default;

  Kind kind;
  const OwnTriangleMeasure* own_measure = nullptr;
};

/// What is measured of two triangles across an inner edge. edge_measures.h has the functions.
struct EdgeMeasure {
  enum Kind : std::uint8_t {
    abn,   ///< the angle between the normals
    jnd,   ///< the jump of the normal derivative
    wabn,  ///< the planar length of the edge times its abn
    own,
  };

  constexpr EdgeMeasure(Kind k) : kind(k) {}  // NOLINT: a kind is a measure
  /// A view: `measure` must outlive all objectives with it.
  constexpr EdgeMeasure(const OwnEdgeMeasure& measure)  // NOLINT
      : kind(own), own_measure(&measure) {}
  EdgeMeasure(OwnEdgeMeasure&&) = delete;
  friend bool operator==(const EdgeMeasure&, const EdgeMeasure&) = default;

  Kind kind;
  const OwnEdgeMeasure* own_measure = nullptr;
};

using Measure = std::variant<TriangleMeasure, EdgeMeasure>;

enum class Aggregate : std::uint8_t { sum, max, min };
enum class Direction : std::uint8_t { minimize, maximize };

struct Objective {
  enum Kind : std::uint8_t {
    none,
    min_local_minima,
    min_local_maxima,
    min_local_extrema,
    min_max_degree,  ///< of vertices
    /// The sum, largest or smallest value of a measure over all triangles, or over all inner edges.
    measured,
  };

  constexpr Objective(Kind k = none) : kind(k) {}  // NOLINT: a kind is an objective
  constexpr Objective(Direction d, Aggregate a, TriangleMeasure m)
      : kind(measured), direction(d), aggregate(a), measure(m) {}
  constexpr Objective(Direction d, Aggregate a, EdgeMeasure m)
      : kind(measured), direction(d), aggregate(a), measure(m) {}
  friend bool operator==(const Objective&, const Objective&) = default;

  Kind kind;
  Direction direction = Direction::minimize;  // from here on: of kind measured
  Aggregate aggregate = Aggregate::sum;
  Measure measure = TriangleMeasure(TriangleMeasure::area);
};

/// Whether the objective's measure is of edges.
inline bool is_of_edges(const Objective& objective) {
  return std::holds_alternative<EdgeMeasure>(objective.measure);
}
/// Whether a sum of lengths counts every edge once, whatever triangles it is in.
inline bool is_total_length(const Objective& objective) {
  return objective.measure == Measure(TriangleMeasure::length) &&
         objective.aggregate == Aggregate::sum;
}

enum class Method {
  automatic,  ///< the best there is, with limited work
  greedy,     ///< independent hulls (Theorem 8); for minima, maxima and extrema
  flip,       ///< flips that improve, as long as there are any
  exact,      ///< as automatic, but searching on until the best is proven, or far longer
};

/// The objective or method of that name on the command line ("min-local-minima",
/// "min-max-angle", "auto"). Throws ParameterError, naming the ones there are, for any other name.
Objective objective_from_name(std::string_view name);
/// The objectives of a list on the command line, commas between: the first counts most. `terrain`
/// stands for the list that came nearest to the land in docs/drainage.md. Throws ParameterError
/// also for what check_objectives() refuses.
std::vector<Objective> objectives_from_names(std::string_view names);
/// The order to take for that list where nobody asks for one.
Index usual_order(std::string_view names);
Method method_from_name(std::string_view name);
std::string name_of(Objective objective);
/// Of objectives in order, with this between them.
std::string names_of(std::span<const Objective> objectives, std::string_view between);
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
/// At most so many objectives can be asked for in order.
inline constexpr std::size_t kMostObjectives = 3;
/// Throws ParameterError if these cannot be objectives in order: one twice, none among several, or
/// too many.
void check_objectives(std::span<const Objective> objectives);

/// Throws ParameterError if the method is not one for the objective.
void check_method(Method method, Objective objective);

/// Throws ParameterError if the objective needs heights and there are none.
void check_heights(Objective objective, bool has_heights);

bool needs_heights(Objective objective);

}  // namespace hodt
