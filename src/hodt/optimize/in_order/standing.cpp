#include "hodt/optimize/in_order/standing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include "hodt/base/exact_sum.h"
#include "hodt/geometry/heights.h"
#include "hodt/mesh/degrees.h"
#include "hodt/optimize/flip/remover_counts.h"
#include "hodt/optimize/measure/edge_measures.h"
#include "hodt/optimize/measure/measures.h"

namespace hodt {

namespace {

/// An exchange takes edges away and brings others, each of which removes one of its ends.
class ExtremaStanding final : public Standing {
 public:
  ExtremaStanding(const Objective& objective, const Heights& heights, const Buffer<bool>& kept,
                  const TriangleMesh& mesh)
      : kept_(kept) {
    for (const Extremum kind : kExtrema)
      if (kind == Extremum::minimum ? counts_minima(objective) : counts_maxima(objective))
        removers_.emplace_back(mesh, heights, kind);
  }
  int effect(const Exchange& exchange) override {
    int extrema = 0;
    bool keeps = true;
    for (RemoverCounts& removers : removers_) {
      extrema += change(exchange.after.inside, removers, 1);
      extrema += change(exchange.before.inside, removers, -1);
      if (removers.kind() == Extremum::minimum)
        for (const Exchange::Edge& e : exchange.after.inside) {
          const VertexId v = removers.removed_by(e.a, e.b);
          keeps &= !kept_[v] || removers.is_extremum(v);
        }
      change(exchange.before.inside, removers, 1);
      change(exchange.after.inside, removers, -1);
    }
    return keeps ? extrema : 1;
  }
  void take(const Exchange& exchange) override {
    for (RemoverCounts& removers : removers_) {
      change(exchange.after.inside, removers, 1);
      change(exchange.before.inside, removers, -1);
    }
  }

 private:
  /// Returns by how many the extrema become more.
  static int change(const std::vector<Exchange::Edge>& edges, RemoverCounts& removers, int by) {
    int extrema = 0;
    for (const Exchange::Edge& e : edges) extrema += removers.change(e.a, e.b, by);
    return extrema;
  }

  const Buffer<bool>& kept_;
  std::vector<RemoverCounts> removers_;
};

class DegreeStanding final : public Standing {
 public:
  explicit DegreeStanding(const TriangleMesh& mesh)
      : degree_(degrees_of(mesh)), most_(*std::max_element(degree_.begin(), degree_.end())) {}

  int effect(const Exchange& exchange) override {
    const auto [before, after] = sorted_degrees(exchange);
    return !after.empty() && after.front() > most_ ? 1 : 0;
  }
  bool is_better(const Exchange& exchange) override {
    const auto [before, after] = sorted_degrees(exchange);
    return after < before;
  }
  void take(const Exchange& exchange) override {
    add(exchange.after, 1);
    add(exchange.before, -1);
  }

 private:
  using Degrees = std::vector<Index>;

  /// Of the vertices that get more or fewer edges, the largest first.
  std::pair<Degrees, Degrees> sorted_degrees(const Exchange& exchange) {
    std::vector<VertexId> vertices;
    for (const auto* edges : {&exchange.before.inside, &exchange.after.inside})
      for (const Exchange::Edge& e : *edges) vertices.insert(vertices.end(), {e.a, e.b});
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const auto sorted = [&] {
      Degrees degrees;
      for (const VertexId v : vertices) degrees.push_back(degree_[v]);
      std::sort(degrees.begin(), degrees.end(), std::greater<>());
      return degrees;
    };
    Degrees before = sorted();
    take(exchange);
    Degrees after = sorted();
    add(exchange.before, 1);
    add(exchange.after, -1);
    return {std::move(before), std::move(after)};
  }
  void add(const Exchange::Side& side, int by) {
    for (const Exchange::Edge& e : side.inside)
      for (const VertexId v : {e.a, e.b}) degree_[v] += static_cast<Index>(by);
  }

  Buffer<Index> degree_;
  const Index most_;
};

void measure(const TriangleValues& values, const Exchange::Side& side, std::vector<double>& found) {
  for (const auto& [a, b, c] : side.triangles) found.push_back(values.of(a, b, c));
}

void measure(const EdgeValues& values, const Exchange::Side& side, std::vector<double>& found) {
  for (const auto* edges : {&side.inside, &side.around})
    for (const auto& [a, b, c, d] : *edges) found.push_back(values.of(a, b, c, d));
}

/// Calls f with the value of every triangle.
template <class F>
void for_each_value(const TriangleValues& values, const TriangleMesh& mesh, const F& f) {
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    f(values.of(a, b, c));
  }
}

/// Calls f with the value of every inner edge.
template <class F>
void for_each_value(const EdgeValues& values, const TriangleMesh& mesh, const F& f) {
  for (Index i = 0; i < mesh.halfedge_count(); ++i)
    if (const HalfEdgeId h(i); mesh.twin(h).valid() && h < mesh.twin(h)) f(values.of(mesh, h));
}

/// What the exchanged triangles, or the edges at them, measure; `Values` of either.
template <class Values>
class MeasuredStanding : public Standing {
 public:
  MeasuredStanding(const Objective& objective, std::span<const Point> xy, std::span<const double> z)
      : values_(objective, xy, z) {}

 protected:
  void measure_both(const Exchange& exchange) {
    before_.clear();
    after_.clear();
    measure(values_, exchange.before, before_);
    measure(values_, exchange.after, after_);
  }

  Values values_;
  std::vector<double> before_, after_;
};

template <class Values>
class SumStanding final : public MeasuredStanding<Values> {
 public:
  using MeasuredStanding<Values>::MeasuredStanding;

  int effect(const Exchange& exchange) override {
    this->measure_both(exchange);
    auto &before = this->before_, &after = this->after_;
    double difference = 0, size = 0;
    for (const double value : after) difference += value, size += value;
    for (const double value : before) difference -= value, size += value;
    difference *= this->values_.sign();
    // What rounding can have made of equal sums is no gain, and yet a loss must be none.
    if (std::fabs(difference) > kRoundingOfSums * size) return difference < 0 ? -1 : 1;
    std::sort(before.begin(), before.end());
    std::sort(after.begin(), after.end());
    if (before == after) return 0;
    ExactSum exact;
    exact.add(after);
    for (const double value : before) exact.subtract(value);
    return this->values_.sign() * exact.nearest() > 0 ? 1 : 0;
  }
};

template <class Values>
class ExtremeStanding final : public MeasuredStanding<Values> {
 public:
  ExtremeStanding(const Objective& objective, std::span<const Point> xy, std::span<const double> z,
                  const TriangleMesh& mesh)
      : MeasuredStanding<Values>(objective, xy, z), value_(this->values_.of(mesh)) {
    if (!this->values_.worst_counts())
      for_each_value(this->values_, mesh, [&](double value) { reaching_ += reaches(value); });
  }

  /// Where the worst of all values counts none may be worse than it, and where the best counts one
  /// at least has to stay as good.
  int effect(const Exchange& exchange) override {
    this->measure_both(exchange);
    if (this->values_.worst_counts())
      return std::all_of(this->after_.begin(), this->after_.end(),
                         [&](double value) { return !this->values_.better(value_, value); })
                 ? 0
                 : 1;
    return reaching_ + count(this->after_) > count(this->before_) ? 0 : 1;
  }
  bool is_better(const Exchange& exchange) override {
    this->measure_both(exchange);
    return is_better_sorted(this->values_, this->before_, this->after_);
  }
  void take(const Exchange& exchange) override {
    if (this->values_.worst_counts()) return;
    this->measure_both(exchange);
    reaching_ += count(this->after_);
    reaching_ -= count(this->before_);
  }

 private:
  bool reaches(double value) const { return !this->values_.better(value_, value); }
  std::size_t count(const std::vector<double>& values) const {
    return static_cast<std::size_t>(
        std::count_if(values.begin(), values.end(), [&](double value) { return reaches(value); }));
  }

  const double value_;
  std::size_t reaching_ = 0;
};

template <class Values>
std::unique_ptr<Standing> measured_standing(const Objective& objective, std::span<const Point> xy,
                                            std::span<const double> z, const TriangleMesh& mesh) {
  if (objective.aggregate == Aggregate::sum)
    return std::make_unique<SumStanding<Values>>(objective, xy, z);
  return std::make_unique<ExtremeStanding<Values>>(objective, xy, z, mesh);
}

}  // namespace

std::unique_ptr<Standing> standing_of(const Objective& objective, std::span<const Point> xy,
                                      std::span<const double> z, const Buffer<bool>& kept,
                                      const TriangleMesh& mesh) {
  if (counts_extrema(objective))
    return std::make_unique<ExtremaStanding>(objective, Heights{xy, z}, kept, mesh);
  if (objective == Objective::min_max_degree) return std::make_unique<DegreeStanding>(mesh);
  return is_of_edges(objective) ? measured_standing<EdgeValues>(objective, xy, z, mesh)
                                : measured_standing<TriangleValues>(objective, xy, z, mesh);
}

}  // namespace hodt
