#include "hodt/picture/order_colours.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace hodt {
namespace {

constexpr LineStyle kAddedEdge{"added", "#0f55a8", 2.6, 1, true};

/// From light to dark, so that they are told apart without colours, too; on a light ground.
constexpr std::array<std::string_view, 5> kColours = {"#e67518", "#d33d5e", "#a3238e", "#5f159e",
                                                      "#150789"};

/// Each order by itself if there are few; else 1, 2, 3 to 4, 5 to 8, and the rest.
std::vector<OrderClass> empty_classes(Index largest) {
  std::vector<OrderClass> classes;
  for (Index low = 1; low <= largest && classes.size() < kColours.size();) {
    Index high = largest <= kColours.size() || low == 1 ? low : 2 * (low - 1);
    if (classes.size() + 1 == kColours.size()) high = largest;
    classes.push_back({low, std::min(high, largest), kAddedEdge, {}});
    low = high + 1;
  }
  return classes;
}

}  // namespace

std::string OrderClass::label() const {
  if (high == 0) return "new edge";
  if (low == high) return fmt::format("new edge of order {}", low);
  return fmt::format("new edge of order {} to {}", low, high);
}

std::vector<OrderClass> order_classes(const Difference& changes) {
  if (changes.added.empty()) return {};
  if (changes.added_order.empty()) return {{0, 0, kAddedEdge, changes.added}};
  const Index largest = *std::max_element(changes.added_order.begin(), changes.added_order.end());
  std::vector<OrderClass> classes = empty_classes(largest);
  for (std::size_t i = 0; i < changes.added.size(); ++i) {
    const auto found = std::find_if(classes.begin(), classes.end(), [&](const OrderClass& each) {
      return changes.added_order[i] <= each.high;
    });
    if (found != classes.end()) found->edges.push_back(changes.added[i]);
  }
  for (std::size_t i = 0; i < classes.size(); ++i)
    classes[i].style.colour =
        classes.size() == 1 ? kColours[2]
                            : kColours[(i * (kColours.size() - 1) + (classes.size() - 1) / 2) /
                                       (classes.size() - 1)];
  std::erase_if(classes, [](const OrderClass& each) { return each.edges.empty(); });
  return classes;
}

}  // namespace hodt
