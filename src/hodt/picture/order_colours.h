// New edges by their order, in a few classes. Internal to this layer.
// Tested by tests/picture/picture_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "hodt/picture/difference.h"
#include "hodt/picture/panel.h"

namespace hodt {

/// Edges of the orders `low` to `high`.
struct OrderClass {
  Index low = 0, high = 0;
  LineStyle style;
  std::vector<Edge> edges;

  std::string label() const;
};

/// The new edges, each in its class, the lowest first; without empty ones. Where orders are not
/// known it is one class, of order 0.
std::vector<OrderClass> order_classes(const Difference& changes);

}  // namespace hodt
