// Quadrilaterals' diagonals chosen so that no vertex gets too many.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "hodt/base/deadline.h"
#include "hodt/base/ids.h"

namespace hodt {

/// Every choice adds 1 at two of its four vertices: at the first two, or at the others.
class DegreeChoices {
 public:
  using Corners = std::array<VertexId, 4>;  // ends of the first diagonal, then of the other

  /// `base`: the degree of every vertex without any of the diagonals.
  DegreeChoices(std::vector<Index> base, std::vector<Corners> choices);

  enum class Answer { possible, impossible, unknown };
  /// Chooses so that no vertex has a degree above `most`. `chosen` (true: the second diagonal) is
  /// changed only if that is possible, and only where it must be. Backtracking with propagation, up
  /// to a fixed amount of work for each part, or until the deadline.
  Answer keep_below(Index most, std::vector<bool>& chosen, const Deadline& deadline = {}) const;

 private:
  class Search;

  std::vector<Index> base_;
  std::vector<Corners> choices_;
  std::vector<std::vector<Index>> choices_at_;
};

}  // namespace hodt
