#include "app/duplicates_text.h"

#include <fmt/format.h>

namespace hodt::app {

std::string difference_text(const std::optional<DuplicateHeights>& heights) {
  if (!heights || heights->different == 0) return {};
  const bool is_one = heights->different == 1;
  const std::string than = heights->rule == DuplicateRule::lowest ? "higher than the one that stays"
                           : heights->rule == DuplicateRule::highest
                               ? "lower than the one that stays"
                           : heights->rule == DuplicateRule::mean ? "from the mean, which stays"
                                                                  : "from the first, which stays";
  return fmt::format("{} {}{:.6g} {}", heights->different, is_one ? "is " : "are up to ",
                     heights->largest_difference, than);
}

std::string dropped_text(std::size_t duplicates, const std::optional<DuplicateHeights>& heights) {
  const std::string differences = difference_text(heights);
  return counted(duplicates, "duplicate") + " dropped" +
         (differences.empty() ? "" : "; " + differences);
}

Json heights_json(const std::optional<DuplicateHeights>& heights) {
  if (!heights) return nullptr;
  return {{"different", heights->different},
          {"largest_difference", to_json(heights->largest_difference)}};
}

}  // namespace hodt::app
