#include "hodt/optimize/objective.h"

#include <array>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "hodt/base/error.h"

namespace hodt {

namespace {

template <class T>
using Named = std::pair<std::string_view, T>;

constexpr std::array<Named<Objective>, 4> kObjectives = {{
    {"min-local-minima", Objective::min_local_minima},
    {"min-local-maxima", Objective::min_local_maxima},
    {"min-local-extrema", Objective::min_local_extrema},
    {"none", Objective::none},
}};

constexpr std::array<Named<Method>, 2> kMethods = {{
    {"auto", Method::automatic},
    {"greedy", Method::greedy},
}};

template <class T>
T from_name(std::string_view name, std::span<const Named<T>> known, std::string_view what) {
  std::string names;
  for (const auto& [known_name, value] : known) {
    if (known_name == name) return value;
    names += fmt::format("{}{}", names.empty() ? "" : ", ", known_name);
  }
  throw ParameterError(fmt::format("unknown {} '{}'; there are {}", what, name, names));
}

}  // namespace

Objective objective_from_name(std::string_view name) {
  return from_name<Objective>(name, kObjectives, "objective");
}

Method method_from_name(std::string_view name) {
  return from_name<Method>(name, kMethods, "method");
}

std::string_view name_of(Objective objective) {
  for (const auto& [name, value] : kObjectives)
    if (value == objective) return name;
  return "unknown";
}

}  // namespace hodt
