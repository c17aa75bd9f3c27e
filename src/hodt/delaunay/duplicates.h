// Which height counts where points have the same (x, y).
#pragma once

#include <cstddef>
#include <string>

#include "hodt/geometry/point_set.h"

namespace hodt {

/// The lowest and the highest; the mean of all; that of the first row; or none: it is an error.
enum class DuplicateRule { lowest, highest, mean, first, error };

/// Of points that are dropped because another one has the same (x, y), and by the rule `lowest` a
/// lower height or comes first.
struct DuplicateHeights {
  std::size_t different = 0;  ///< those of another height than the one that stays
  double largest_difference = 0;
  DuplicateRule rule = DuplicateRule::lowest;
};

/// Gives points with the same (x, y) the height that counts by the rule, so that the first row of
/// them stands for all; of `lowest`, which is the rule of every triangulation, nothing is to be
/// done. Does nothing without heights, but for `error`. Throws InputError, naming two rows, if by
/// the rule there may be none; and if a coordinate is not finite.
DuplicateHeights settle_duplicates(PointSet& points, DuplicateRule rule);

/// "mean", or the rule of a name. Throws ParameterError for any other.
std::string name_of(DuplicateRule rule);
DuplicateRule duplicate_rule(const std::string& option, const std::string& name);

}  // namespace hodt
