// How many points lie beyond every line through a point, from below.
#pragma once

#include "hodt/base/buffer.h"
#include "hodt/base/ids.h"

namespace hodt {

/// A set of points p around the origin, to which more can be added. *Beyond* a line is the side
/// where the origin is not. The directions of lines are cut into sectors; of each the set keeps the
/// k + 1 largest distances that some point is beyond in all directions of the sector. Rough and
/// very fast: single precision, all sectors side by side, with the rounding bounded. (KLevel is for
/// large k: its sectors are as narrow as it takes.)
class SectorLevels {
 public:
  /// No points; questions are for up to k.
  void clear(Index k);

  /// Adds the points of places `first` to `last` - 1.
  void add(const float* x, const float* y, Index first, Index last);

  /// Sets counts[i] for the places of `first` to `last` - 1: surely so many points are beyond every
  /// line through point i, as far as that is k or k + 1, or else 0. Reads and writes 15 places
  /// more.
  void bound(const float* x, const float* y, Index first, Index last, Index* counts) const;

 private:
  Index k_ = 0;
  Buffer<float> levels_;  // the largest distances of all sectors, then the second largest, ...
};

}  // namespace hodt
