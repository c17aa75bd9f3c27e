// Many choices between two whose costs count in order: the first cost decides, and the next where
// that is equal.
// Tested by tests/optimize/ordered_choices_test.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hodt/base/deadline.h"
#include "hodt/base/ids.h"

namespace hodt {

/// All costs are added up but those of the last level, which can also be combined to the largest or
/// the smallest one. No sum is rounded, so that equal is equal.
class OrderedChoices {
 public:
  enum class Combine : std::uint8_t { sum, max, min };
  static constexpr std::size_t kMostLevels = 3;
  static constexpr std::size_t kWidest = 12;  ///< choices that a table of costs may depend on

  OrderedChoices(Index count, std::size_t levels, Combine last);

  /// What some choices cost together, on that level. `costs` has one for every setting: bit j of
  /// its number is choice j of them. REQUIRES that the choices are different, and finite costs. Of
  /// more than kWidest choices the costs are not looked at, and what hangs together with them is
  /// not solved.
  void add(std::size_t level, std::span<const Index> choices, std::span<const double> costs);
  /// No solution has these choices like that.
  void forbid(std::span<const Index> choices, std::size_t setting);

  struct Result {
    std::vector<bool> chosen;
    /// Whether a choice belongs to a part that was solved: it is as in the best of all solutions,
    /// whatever is chosen in other parts. Not so where choices hang together too much (as on
    /// lattices), where the bits of the costs span too much to be added up, or where the deadline
    /// had passed.
    std::vector<bool> is_solved;
  };
  Result best(const Deadline& deadline = {}) const;

 private:
  class Part;
  static constexpr std::size_t kForbidden = kMostLevels;  // its level

  struct Term {
    std::size_t level;
    std::size_t first_choice, size;
    std::size_t first_cost;  // of those added; or the setting that is forbidden
  };
  std::span<const Index> choices_of(const Term& term) const {
    return {choices_.data() + term.first_choice, term.size};
  }
  std::vector<std::vector<Index>> terms_by_parts() const;

  const Index count_;
  const std::size_t levels_;
  const Combine last_;
  std::vector<Term> terms_;
  std::vector<Index> choices_;
  std::vector<double> costs_;
};

}  // namespace hodt
