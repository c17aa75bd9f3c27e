#include "hodt/optimize/edge_measure/fan_bound.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

#include "hodt/base/lanes.h"
#include "hodt/base/parallel.h"
#include "hodt/geometry/predicates.h"
#include "hodt/optimize/edge_measure/useful_neighbours.h"
#include "hodt/optimize/rounded_sum.h"

namespace hodt {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Points around a vertex, inverted there: its circles become lines.
class InvertedPoints {
 public:
  void clear() { x_.clear(), y_.clear(), largest_ = 0; }
  /// A point at this offset from the vertex.
  void add(double x, double y) {
    const double square = x * x + y * y;
    const bool is_plain = square > 0x1p-900 && square < 0x1p900;
    x_.push_back(x / square);
    y_.push_back(y / square);
    largest_ =
        is_plain ? std::max({largest_, std::fabs(x_.back()), std::fabs(y_.back())}) : kInfinity;
  }
  /// How many are inside the circle through the vertex and points i and j, counter-clockwise, for
  /// certain. Those are beyond the line through i and j.
  std::int64_t count_inside(std::size_t i, std::size_t j) const {
    const double x = x_[i], y = y_[i], dx = x_[j] - x, dy = y_[j] - y;
    // Of what was inverted nothing is wrong by more than 2^-50 of itself.
    const double margin = 0x1p-44 * largest_ * largest_;
    const double *const px = x_.data(), *const py = y_.data();
    const std::size_t size = x_.size();
    return run_in_lanes([=]<Index>() HODT_INLINE_LAMBDA {
      std::int64_t count = 0;
      for (std::size_t p = 0; p < size; ++p)
        count += std::int64_t{dy * (px[p] - x) - dx * (py[p] - y) > margin};
      return count;
    });
  }

 private:
  std::vector<double> x_, y_;
  double largest_ = 0;
};

/// A triangle at the vertex, from one neighbour to another, counter-clockwise.
struct Arc {
  Index from, to;
};

/// The best fan at one vertex after another. Holds scratch memory for one thread.
class BestFan {
 public:
  BestFan(const DelaunayGraph& graph, const EdgeValues& values, Index order,
          const UsefulNeighbours& neighbours)
      : graph_(graph),
        values_(values),
        sign_(values.sign()),
        order_(order),
        neighbours_(neighbours),
        many_(values),
        place_(graph.xy.size(), kNone) {}

  /// What its spokes' values sum up to, no worse for rounding.
  double at(VertexId v) {
    center_ = v;
    gather_neighbours();
    find_arcs();
    measure_spokes();
    const double best = is_on_boundary() ? best_from_side_to_side() : best_around();
    if (best == kInfinity) throw std::logic_error("no triangles go around a vertex");
    const double error = double(size() + 2) * 0x1p-52 * std::fabs(best);
    return bound_within(values_, sign_ * best, error);
  }

 private:
  /// More neighbours are not looked through for each triangle.
  static constexpr std::size_t kMany = 256;

  std::size_t size() const { return around_.size(); }
  const Point& point(Index i) const { return graph_.point(VertexId(around_[i])); }
  bool is_on_boundary() const { return graph_.mesh.is_boundary(graph_.outgoing[center_]); }

  void gather_neighbours();
  void find_arcs();
  bool can_be_in_fan(Index from, Index to) const;
  void sort_arcs();
  void measure_spokes();
  double best_around();
  double best_from_side_to_side();
  void begin() { best_to_.assign(arcs_.size(), kInfinity); }
  void pass(Index spoke, Index start);

  const DelaunayGraph& graph_;
  const EdgeValues& values_;
  const double sign_;  // times it, less is better
  const Index order_;
  const UsefulNeighbours& neighbours_;
  ManyEdges many_;
  Buffer<Index> place_;  // of each neighbour around the vertex, else kNone

  VertexId center_;
  std::vector<Index> around_;  // the neighbours, counter-clockwise
  InvertedPoints inverted_;
  // The arcs by where they begin, and for each spoke the first of those; the places of the arcs by
  // where they end, and the first of those.
  std::vector<Arc> arcs_, found_, candidates_;
  std::vector<EdgeValues::Gradient> gradients_;
  std::vector<Index> first_from_, first_to_, arc_to_, place_to_;
  // Of each arc: the spoke where it begins between each one that ends there and it.
  std::vector<double> costs_;
  std::vector<std::size_t> first_cost_;
  std::vector<double> best_to_;  // of fans that end with an arc, by places by where they end
  std::vector<Index> covers_;
};

/// Counter-clockwise from the direction to the left, that included.
void BestFan::gather_neighbours() {
  const Point& center = graph_.point(center_);
  const auto all = neighbours_.of(center_);
  around_.assign(all.begin(), all.end());
  const auto is_below = [&](Index w) {
    const Point& p = graph_.point(VertexId(w));
    return p.y < center.y || (p.y == center.y && p.x < center.x);
  };
  const auto middle = std::partition(around_.begin(), around_.end(), is_below);
  const auto is_before = [&](Index a, Index b) {
    const int turn = orient(center, graph_.point(VertexId(a)), graph_.point(VertexId(b)));
    return turn != 0 ? turn > 0 : a < b;
  };
  std::sort(around_.begin(), middle, is_before);
  std::sort(middle, around_.end(), is_before);
  inverted_.clear();
  for (Index i = 0; i < size(); ++i) {
    place_[around_[i]] = i;
    inverted_.add(point(i).x - center.x, point(i).y - center.y);
  }
}

void BestFan::find_arcs() {
  // Without branches on what is a matter of chance.
  candidates_.clear();
  for (Index i = 0; i < size(); ++i) {
    const auto greater = neighbours_.greater_of(VertexId(around_[i]));
    std::size_t count = candidates_.size();
    candidates_.resize(count + greater.size());
    for (const Index w : greater) {
      candidates_[count] = {i, place_[w]};
      count += std::size_t{place_[w] != kNone};
    }
    candidates_.resize(count);
  }
  for (const Index w : around_) place_[w] = kNone;
  const Point& center = graph_.point(center_);
  found_.clear();
  for (const auto& [i, j] : candidates_) {
    const int turn = orient(center, point(i), point(j));
    const Arc arc{turn > 0 ? i : j, turn > 0 ? j : i};
    if (turn != 0 && can_be_in_fan(arc.from, arc.to)) found_.push_back(arc);
  }
  sort_arcs();
}

/// Whether the triangle may be empty, with so few points in its circle. (With walls, only those
/// count that are reached.)
bool BestFan::can_be_in_fan(Index from, Index to) const {
  if (size() > kMany) return true;
  if (!graph_.has_walls() && inverted_.count_inside(from, to) > order_) return false;
  for (Index i = from + 1 == size() ? 0 : from + 1; i != to; i = i + 1 == size() ? 0 : i + 1)
    if (orient(point(from), point(to), point(i)) > 0) return false;
  return true;
}

void BestFan::sort_arcs() {
  first_from_.assign(size() + 1, 0);
  first_to_.assign(size() + 1, 0);
  for (const Arc& arc : found_) ++first_from_[arc.from + 1], ++first_to_[arc.to + 1];
  std::partial_sum(first_from_.begin(), first_from_.end(), first_from_.begin());
  std::partial_sum(first_to_.begin(), first_to_.end(), first_to_.begin());
  arcs_.resize(found_.size());
  gradients_.resize(found_.size());
  arc_to_.resize(found_.size());
  place_to_.resize(found_.size());
  for (const Arc& arc : found_) arcs_[first_from_[arc.from]++] = arc;
  for (Index a = 0; a < arcs_.size(); ++a) {
    const Arc& arc = arcs_[a];
    gradients_[a] =
        values_.gradient(center_, VertexId(around_[arc.from]), VertexId(around_[arc.to]));
    place_to_[a] = first_to_[arc.to]++;
    arc_to_[place_to_[a]] = a;
  }
  for (std::vector<Index>* const first : {&first_from_, &first_to_}) {
    std::copy_backward(first->begin(), first->end() - 1, first->end());
    first->front() = 0;
  }
}

void BestFan::measure_spokes() {
  first_cost_.resize(arcs_.size());
  costs_.clear();
  std::size_t size_of_block = 0;
  const auto measure = [&] {
    const double* const values = many_.measure(size_of_block, 0, 0);
    costs_.insert(costs_.end(), values, values + size_of_block);
    size_of_block = 0;
  };
  std::size_t count = 0;
  for (Index spoke = 0; spoke < size(); ++spoke)
    for (Index a = first_from_[spoke]; a < first_from_[spoke + 1]; ++a) {
      first_cost_[a] = count;
      count += first_to_[spoke + 1] - first_to_[spoke];
      for (Index place = first_to_[spoke]; place < first_to_[spoke + 1]; ++place) {
        const EdgeValues::Gradient &left = gradients_[a], &right = gradients_[arc_to_[place]];
        many_.set(size_of_block++, center_, VertexId(around_[spoke]), left, right);
        if (size_of_block == ManyEdges::kSize) measure();
      }
    }
  measure();
  for (double& cost : costs_) cost *= sign_;
}

/// Goes on from all that ends at the spoke, but for what leaps over the start: its edge would cross
/// that triangle.
void BestFan::pass(Index spoke, Index start) {
  const auto steps = [&](Index i) { return i < start ? i + Index(size()) - start : i - start; };
  const Index begin = first_to_[spoke], count = first_to_[spoke + 1] - begin;
  for (Index a = first_from_[spoke]; a < first_from_[spoke + 1]; ++a) {
    if (arcs_[a].to != start && steps(arcs_[a].to) < steps(spoke)) continue;
    const double *const cost = &costs_[first_cost_[a]], *const before = &best_to_[begin];
    double best = kInfinity;
    for (Index i = 0; i < count; ++i) best = std::min(best, before[i] + cost[i]);
    best_to_[place_to_[a]] = best;
  }
}

/// Every fan has one arc over each gap between two spokes: it begins with one over the gap that the
/// fewest are over.
double BestFan::best_around() {
  const auto m = static_cast<Index>(size());
  covers_.assign(m, 0);
  const auto next = [&](Index i) { return i + 1 == m ? 0 : i + 1; };
  for (const Arc& arc : arcs_)
    for (Index i = arc.from; i != arc.to; i = next(i)) ++covers_[i];
  const auto gap = Index(std::min_element(covers_.begin(), covers_.end()) - covers_.begin());
  double best = kInfinity;
  for (Index a = 0; a < arcs_.size(); ++a) {
    const auto [from, to] = arcs_[a];
    if (from <= to ? gap < from || gap >= to : gap < from && gap >= to) continue;
    begin();
    best_to_[place_to_[a]] = 0;
    for (Index spoke = to; spoke != from; spoke = next(spoke)) pass(spoke, from);
    const double* const cost = &costs_[first_cost_[a]];
    for (Index place = first_to_[from]; place < first_to_[from + 1]; ++place)
      best = std::min(best, best_to_[place] + cost[place - first_to_[from]]);
  }
  return best;
}

/// On the boundary, from the first side to the last.
double BestFan::best_from_side_to_side() {
  const auto place = [&](VertexId w) {
    return Index(std::find(around_.begin(), around_.end(), w) - around_.begin());
  };
  const HalfEdgeId first = graph_.outgoing[center_];
  HalfEdgeId last = first;
  for (HalfEdgeId h = first; h.valid(); h = graph_.mesh.rotate_ccw(h)) last = h;
  const Index start = place(graph_.mesh.target(first)), end = place(graph_.mesh.apex(last));
  begin();
  for (Index a = first_from_[start]; a < first_from_[start + 1]; ++a) best_to_[place_to_[a]] = 0;
  const auto next = [&](Index i) { return i + 1 == size() ? 0 : i + 1; };
  for (Index spoke = next(start); spoke != end; spoke = next(spoke)) pass(spoke, start);
  return *std::min_element(best_to_.begin() + first_to_[end],
                           best_to_.begin() + first_to_[end + 1]);
}

/// Half of it, rounded outward.
double half(const Aggregator& aggregator, double value) {
  const double halved = value / 2;
  return halved + halved == value ? halved : outward(halved, aggregator.sign());
}

}  // namespace

double bound_by_fans(const DelaunayGraph& graph, const EdgeValues& values, Index order,
                     const Deadline& deadline) {
  const UsefulNeighbours neighbours(graph, order, deadline);
  PerThread<BestFan> fans([&] { return BestFan(graph, values, order, neighbours); });
  const auto add = [&](std::size_t first, std::size_t last, std::vector<Total>& parts) {
    BestFan& fan = fans.mine();
    Total& part = parts.emplace_back(values);
    for (std::size_t v = first; v < last; ++v) {
      deadline.check();
      part.add(half(values, fan.at(VertexId(Index(v)))));
    }
  };
  Total total(values);
  for (const Total& part : parallel_collect<Total>(0, graph.xy.size(), 1 << 12, add))
    total.add(part);
  return total.bound();
}

}  // namespace hodt
