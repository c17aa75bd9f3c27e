// How a triangulation stands with an objective, and what an exchange of triangles does to that.
// Tested by tests/optimize/in_order_test.cpp.
#pragma once

#include <memory>
#include <span>

#include "hodt/base/buffer.h"
#include "hodt/geometry/point.h"
#include "hodt/optimize/in_order/exchange.h"
#include "hodt/optimize/objective.h"

namespace hodt {

class Standing {
 public:
  Standing() = default;
  Standing(const Standing&) = delete;
  Standing& operator=(const Standing&) = delete;
  virtual ~Standing() = default;

  /// More than 0 if an exchange made the objective's value worse than it is (of largest and
  /// smallest values and degrees: than it was at the start), less than 0 if better by more than
  /// rounding can have made of nothing, otherwise 0.
  virtual int effect(const Exchange& exchange) = 0;
  /// Whether it would be a step to a better value: of largest and smallest values also one among
  /// those that do not decide.
  virtual bool is_better(const Exchange& exchange) { return effect(exchange) < 0; }
  /// The exchange was made.
  virtual void take(const Exchange&) {}
};

/// The standing of a mesh with these vertices. `kept`: minima that have to stay, a flag for every
/// vertex, for objectives that count minima. A view of all but the mesh.
std::unique_ptr<Standing> standing_of(const Objective& objective, std::span<const Point> xy,
                                      std::span<const double> z, const Buffer<bool>& kept,
                                      const TriangleMesh& mesh);

}  // namespace hodt
