#include "app/duplicates_text.h"

#include <fmt/format.h>

namespace hodt::app {

std::string higher_text(const std::optional<DuplicateHeights>& heights) {
  if (!heights || heights->different == 0) return {};
  if (heights->different == 1)
    return fmt::format("1 is {:.6g} higher than the one that stays", heights->largest_difference);
  return fmt::format("{} are up to {:.6g} higher than the one that stays", heights->different,
                     heights->largest_difference);
}

std::string dropped_text(std::size_t duplicates, const std::optional<DuplicateHeights>& heights) {
  const std::string higher = higher_text(heights);
  return counted(duplicates, "duplicate") + " dropped" + (higher.empty() ? "" : "; " + higher);
}

Json heights_json(const std::optional<DuplicateHeights>& heights) {
  if (!heights) return nullptr;
  return {{"different", heights->different},
          {"largest_difference", to_json(heights->largest_difference)}};
}

}  // namespace hodt::app
