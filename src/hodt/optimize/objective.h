// What a triangulation can be made best for, and by which method.
#pragma once

#include <string_view>

namespace hodt {

enum class Objective { none, min_local_minima, min_local_maxima, min_local_extrema };
enum class Method { automatic, greedy };

/// The objective or method of that name on the command line ("min-local-minima", "auto").
/// Throws ParameterError, naming the ones there are, for any other name.
Objective objective_from_name(std::string_view name);
Method method_from_name(std::string_view name);
std::string_view name_of(Objective objective);

inline bool counts_minima(Objective objective) {
  return objective == Objective::min_local_minima || objective == Objective::min_local_extrema;
}
inline bool counts_maxima(Objective objective) {
  return objective == Objective::min_local_maxima || objective == Objective::min_local_extrema;
}

}  // namespace hodt
