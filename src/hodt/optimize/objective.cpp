#include "hodt/optimize/objective.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "hodt/base/error.h"

namespace hodt {

namespace {

template <class T>
using Named = std::pair<std::string_view, T>;

constexpr std::array<Named<Objective::Kind>, 5> kKinds = {{
    {"min-local-minima", Objective::min_local_minima},
    {"min-local-maxima", Objective::min_local_maxima},
    {"min-local-extrema", Objective::min_local_extrema},
    {"min-max-degree", Objective::min_max_degree},
    {"none", Objective::none},
}};

constexpr std::array<Named<Direction>, 2> kDirections = {{
    {"min", Direction::minimize},
    {"max", Direction::maximize},
}};

constexpr std::array<Named<Aggregate>, 3> kAggregates = {{
    {"sum", Aggregate::sum},
    {"max", Aggregate::max},
    {"min", Aggregate::min},
}};

constexpr std::array<Named<Measure>, 11> kMeasures = {{
    {"area", TriangleMeasure(TriangleMeasure::area)},
    {"angle", TriangleMeasure(TriangleMeasure::angle)},
    {"small-angle", TriangleMeasure(TriangleMeasure::small_angle)},
    {"circumradius", TriangleMeasure(TriangleMeasure::circumradius)},
    {"enclosing-radius", TriangleMeasure(TriangleMeasure::enclosing_radius)},
    {"inradius", TriangleMeasure(TriangleMeasure::inradius)},
    {"length", TriangleMeasure(TriangleMeasure::length)},
    {"flat-area", TriangleMeasure(TriangleMeasure::flat_area)},
    {"abn", EdgeMeasure(EdgeMeasure::abn)},
    {"jnd", EdgeMeasure(EdgeMeasure::jnd)},
    {"wabn", EdgeMeasure(EdgeMeasure::wabn)},
}};

constexpr std::array<Named<Method>, 4> kMethods = {{
    {"auto", Method::automatic},
    {"greedy", Method::greedy},
    {"flip", Method::flip},
    {"exact", Method::exact},
}};

constexpr std::string_view kTerrain = "terrain", kForTerrain = "min-local-minima,min-sum-abn";

template <class Known>
std::string names_of(const Known& known) {
  std::string names;
  for (const auto& [name, value] : known)
    names += fmt::format("{}{}", names.empty() ? "" : ", ", name);
  return names;
}

template <class Known>
auto find_name(const Known& known, std::string_view name)
    -> std::optional<typename Known::value_type::second_type> {
  for (const auto& [known_name, value] : known)
    if (known_name == name) return value;
  return std::nullopt;
}

template <class Known, class T>
std::string_view name_in(const Known& known, T value) {
  for (const auto& [name, known_value] : known)
    if (known_value == value) return name;
  return "unknown";
}

/// "min-max-small-angle" is min, max and small-angle.
std::optional<Objective> measured_from_name(std::string_view name) {
  const std::size_t first = name.find('-');
  if (first == name.npos) return std::nullopt;
  const std::size_t second = name.find('-', first + 1);
  if (second == name.npos) return std::nullopt;
  const auto direction = find_name(kDirections, name.substr(0, first));
  const auto aggregate = find_name(kAggregates, name.substr(first + 1, second - first - 1));
  const auto measure = find_name(kMeasures, name.substr(second + 1));
  if (!direction || !aggregate || !measure) return std::nullopt;
  return std::visit([&](auto m) { return Objective(*direction, *aggregate, m); }, *measure);
}

std::string name_of(const Measure& measure) {
  return std::visit(
      [&](const auto& m) {
        return m.own_measure ? m.own_measure->name : std::string(name_in(kMeasures, measure));
      },
      measure);
}

}  // namespace

Objective objective_from_name(std::string_view name) {
  if (const auto kind = find_name(kKinds, name)) return *kind;
  if (const auto measured = measured_from_name(name)) return *measured;
  if (name == kTerrain)
    throw ParameterError(
        fmt::format("{} stands for {}, and can be no part of a list", kTerrain, kForTerrain));
  throw ParameterError(
      fmt::format("unknown objective '{}'; there are {}, {}, and <min|max>-<sum|max|min>-MEASURE, "
                  "where MEASURE is "
                  "one of {}",
                  name, names_of(kKinds), kTerrain, measure_names()));
}

std::vector<Objective> objectives_from_names(std::string_view names) {
  if (names == kTerrain) names = kForTerrain;
  std::vector<Objective> objectives;
  for (;;) {
    const std::size_t comma = names.find(',');
    objectives.push_back(objective_from_name(names.substr(0, comma)));
    if (comma == names.npos) break;
    names.remove_prefix(comma + 1);
  }
  check_objectives(objectives);
  return objectives;
}

std::string names_of(std::span<const Objective> objectives, std::string_view between) {
  std::string names;
  for (const Objective& objective : objectives) {
    if (!names.empty()) names += between;
    names += name_of(objective);
  }
  return names;
}

Index usual_order(std::string_view names) {
  return names == kTerrain ? 8 : 4;
}

void check_objectives(std::span<const Objective> objectives) {
  if (objectives.size() > kMostObjectives)
    throw ParameterError(fmt::format("{} objectives in order are too many; there can be {}",
                                     objectives.size(), kMostObjectives));
  for (auto it = objectives.begin(); it != objectives.end(); ++it) {
    if (*it == Objective::none && objectives.size() > 1)
      throw ParameterError("the objective none leaves nothing to choose, and can only stand alone");
    if (std::find(objectives.begin(), it, *it) != it)
      throw ParameterError(
          fmt::format("the objective {} is in the list twice; once it is as good as it can be, "
                      "there is nothing "
                      "more to ask of it",
                      name_of(*it)));
  }
}

Method method_from_name(std::string_view name) {
  if (const auto method = find_name(kMethods, name)) return *method;
  throw ParameterError(fmt::format("unknown method '{}'; there are {}", name, names_of(kMethods)));
}

void check_method(Method method, Objective objective) {
  if (method != Method::greedy || objective == Objective::none || counts_extrema(objective)) return;
  throw ParameterError(
      fmt::format("the method {} is not one for {}: it is for local minima, maxima and extrema; "
                  "auto, flip and exact are for all",
                  name_in(kMethods, method), name_of(objective)));
}

std::string measure_names() {
  return names_of(kMeasures);
}

std::string name_of(Objective objective) {
  if (objective.kind != Objective::measured) return std::string(name_in(kKinds, objective.kind));
  return fmt::format("{}-{}-{}", name_in(kDirections, objective.direction),
                     name_in(kAggregates, objective.aggregate), name_of(objective.measure));
}

bool needs_heights(Objective objective) {
  if (objective.kind != Objective::measured) return counts_extrema(objective);
  if (objective.measure == Measure(TriangleMeasure::flat_area)) return true;
  return std::visit(
      [&](const auto& m) {
        return m.own_measure ? m.own_measure->needs_heights : is_of_edges(objective);
      },
      objective.measure);
}

void check_heights(Objective objective, bool has_heights) {
  if (!needs_heights(objective) || has_heights) return;
  throw ParameterError(fmt::format(
      "the objective {} needs heights, and the points have none; add a z column or choose none",
      name_of(objective)));
}

}  // namespace hodt
