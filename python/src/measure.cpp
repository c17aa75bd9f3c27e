#include "measure.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <span>
#include <unordered_map>
#include <vector>

#include <fmt/format.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>

#include "hodt/base/error.h"
#include "hodt/base/stop.h"
#include "hodt/delaunay/delaunay.h"
#include "hodt/geometry/predicates.h"
#include "hodt/order/triangles.h"

namespace hodt::python {

namespace {

using Numbers = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

struct HashOfPoint {
  std::size_t operator()(const Point& p) const {
    const std::size_t x = std::hash<double>()(p.x), y = std::hash<double>()(p.y);
    return x ^ (y * 0x9E3779B97F4A7C15u + (x << 6) + (x >> 2));
  }
};

/// What Python says of the corners of `count` triangles, or of two triangles each: `places` arrays.
/// Takes Python's lock.
std::vector<double> ask(const nb::handle function, const std::string& name, std::size_t places,
                        std::span<const Corner> corners) {
  check_stop();  // Python may be at its end
  const nb::gil_scoped_acquire lock;
  const std::size_t count = corners.size() / places;
  nb::list arguments;
  for (std::size_t i = 0; i < places; ++i) {
    auto* const copy = new std::vector<Corner>(corners.begin() + std::ptrdiff_t(i * count),
                                               corners.begin() + std::ptrdiff_t((i + 1) * count));
    const nb::capsule owner(copy,
                            [](void* p) noexcept { delete static_cast<std::vector<Corner>*>(p); });
    arguments.append(
        nb::cast(nb::ndarray<nb::numpy, double>(copy->data(), {count, std::size_t{3}}, owner)));
  }
  const nb::object answer = function(*arguments);
  Numbers values;
  if (!nb::try_cast<Numbers>(answer, values) || values.shape(0) != count)
    throw ParameterError(fmt::format(
        "the measure {} has to return an array of {} numbers, one for each row of its arguments",
        name, count));
  return {values.data(), values.data() + count};
}

/// Which point a corner is.
class RowsOfCorners {
 public:
  RowsOfCorners() = default;
  RowsOfCorners(const PointSet& points, const Delaunay& d) {
    for (const Index row : d.vertices.row) row_at_.emplace(points.xy[row], row);
  }
  Index operator()(const Corner& corner) const { return row_at_.at({corner.x, corner.y}); }

 private:
  std::unordered_map<Point, Index, HashOfPoint> row_at_;
};

}  // namespace

class OwnMeasure::Answers {
 public:
  Answers(nb::handle function, std::string name) : function_(function), name_(std::move(name)) {}

  void prepare(const PointSet& points, Index order) {
    points_ = &points;
    const Delaunay d = delaunay(points);
    row_of_ = RowsOfCorners(points, d);
    if (order > kMostOrder) return;
    DelaunayGraph graph(d);
    graph.list_neighbours();
    first_.assign(points.size() + 1, 0);
    for_each_triangle(graph, TriangleClass::valid, std::min<Index>(order, Index(points.size())),
                      row_numbering(d.vertices, points.size()),
                      [&](std::span<const TriangleRecord> records) { add(records); });
    for (std::size_t row = 0; row < points.size(); ++row) first_[row + 1] += first_[row];
  }

  double of(const Corner& a, const Corner& b, const Corner& c) {
    std::array<Index, 3> rows = {row_of_(a), row_of_(b), row_of_(c)};
    std::rotate(rows.begin(), std::min_element(rows.begin(), rows.end()), rows.end());
    const Known key = {std::min(rows[1], rows[2]), std::max(rows[1], rows[2]), 0};
    if (!first_.empty()) {
      const auto begin = known_.begin() + std::ptrdiff_t(first_[rows[0]]);
      const auto end = known_.begin() + std::ptrdiff_t(first_[rows[0] + 1]);
      const auto found = std::lower_bound(begin, end, key);
      if (found != end && found->b == key.b && found->c == key.c) return found->value;
    }
    return of_another(rows);
  }

 private:
  static constexpr Index kMostOrder = 16;  // with more there are too many triangles to ask for
  static constexpr std::size_t kBatch = 1 << 16;

  /// Of a triangle whose least row is that which it is listed under.
  struct Known {
    Index b, c;
    double value;
    bool operator<(const Known& other) const { return b != other.b ? b < other.b : c < other.c; }
  };

  Corner corner(Index row) const {
    const Point& p = points_->xy[row];
    return {p.x, p.y, points_->has_heights() ? points_->z[row] : 0};
  }

  void add(std::span<const TriangleRecord> records) {
    std::vector<Corner> corners;
    for (; !records.empty(); records = records.subspan(std::min(kBatch, records.size()))) {
      const auto batch = records.first(std::min(kBatch, records.size()));
      corners.resize(3 * batch.size());
      for (std::size_t i = 0; i < batch.size(); ++i) {
        auto [a, b, c, order] = batch[i];
        ++first_[a + 1];
        known_.push_back({b, c, 0});
        const auto& xy = points_->xy;
        if (orient(xy[a], xy[b], xy[c]) < 0) std::swap(b, c);
        corners[i] = corner(a);
        corners[batch.size() + i] = corner(b);
        corners[2 * batch.size() + i] = corner(c);
      }
      const std::vector<double> values = ask(function_, name_, 3, corners);
      for (std::size_t i = 0; i < values.size(); ++i)
        known_[known_.size() - values.size() + i].value = values[i];
    }
  }

  /// Counter-clockwise. Once asked for, an answer stays the same.
  double of_another(const std::array<Index, 3>& rows) {
    {
      const std::lock_guard lock(mutex_);
      const auto found = others_.find(rows);
      if (found != others_.end()) return found->second;
    }
    const Corner corners[] = {corner(rows[0]), corner(rows[1]), corner(rows[2])};
    const double value = ask(function_, name_, 3, corners)[0];
    const std::lock_guard lock(mutex_);
    return others_.emplace(rows, value).first->second;
  }

  nb::handle function_;
  std::string name_;
  const PointSet* points_ = nullptr;
  RowsOfCorners row_of_;
  std::vector<std::size_t> first_;  // of each row where its triangles begin
  std::vector<Known> known_;
  std::mutex mutex_;
  std::map<std::array<Index, 3>, double> others_;
};

/// Numpy may give other last bits where it is asked for another number of rows. So once asked for,
/// an answer stays the same here, too.
class OwnMeasure::EdgeAnswers {
 public:
  EdgeAnswers(nb::handle function, std::string name)
      : function_(function), name_(std::move(name)) {}

  void prepare(const PointSet& points) { row_of_ = RowsOfCorners(points, delaunay(points)); }

  void of(std::span<const std::array<Corner, 4>> edges, std::span<double> values) {
    std::vector<Rows> rows(edges.size());
    std::ranges::transform(edges, rows.begin(), [&](const auto& edge) { return rows_of(edge); });
    const std::vector<std::size_t> unknown = look_up(rows, values);
    if (unknown.empty()) return;
    std::vector<Corner> corners(4 * unknown.size());
    for (std::size_t i = 0; i < unknown.size(); ++i)
      for (std::size_t place = 0; place < 4; ++place)
        corners[place * unknown.size() + i] = edges[unknown[i]][place];
    const std::vector<double> answers = ask(function_, name_, 4, corners);
    const std::lock_guard lock(mutex_);  // another thread may have asked for the same
    for (std::size_t i = 0; i < unknown.size(); ++i)
      values[unknown[i]] = known_.emplace(rows[unknown[i]], answers[i]).first->second;
  }

 private:
  using Rows = std::array<Index, 4>;

  struct HashOfRows {
    std::size_t operator()(const Rows& rows) const {
      std::size_t hash = 0;
      for (const Index row : rows) hash = (hash ^ row) * 0x9E3779B97F4A7C15u;
      return hash ^ (hash >> 32);
    }
  };

  Rows rows_of(const std::array<Corner, 4>& edge) const {
    return {row_of_(edge[0]), row_of_(edge[1]), row_of_(edge[2]), row_of_(edge[3])};
  }

  /// Fills in the values that are known. Those that are not, by their places.
  std::vector<std::size_t> look_up(const std::vector<Rows>& rows, std::span<double> values) {
    std::vector<std::size_t> unknown;
    const std::lock_guard lock(mutex_);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto found = known_.find(rows[i]);
      if (found != known_.end())
        values[i] = found->second;
      else
        unknown.push_back(i);
    }
    return unknown;
  }

  nb::handle function_;
  std::string name_;
  RowsOfCorners row_of_;
  std::mutex mutex_;  // never held where Python's lock is waited for
  std::unordered_map<Rows, double, HashOfRows> known_;
};

OwnMeasure::OwnMeasure(nb::handle objective) {
  if (nb::isinstance<nb::str>(objective)) {
    then_ = objectives_from_names(nb::cast<std::string>(objective));
    objective_ = then_.front();
    then_.erase(then_.begin());
    return;
  }
  const auto name = nb::cast<std::string>(objective.attr("name"));
  const bool needs_heights = nb::cast<bool>(objective.attr("needs_heights"));
  function_ = objective.attr("of");
  const auto aggregate_name = nb::cast<std::string>(objective.attr("aggregate"));
  const Direction direction = nb::cast<std::string>(objective.attr("direction")) == "max"
                                  ? Direction::maximize
                                  : Direction::minimize;
  const Aggregate aggregate = aggregate_name == "sum"   ? Aggregate::sum
                              : aggregate_name == "max" ? Aggregate::max
                                                        : Aggregate::min;
  if (nb::cast<bool>(objective.attr("across_edges"))) {
    edge_answers_ = std::make_unique<EdgeAnswers>(function_, name);
    const auto of_many = [this](std::span<const std::array<Corner, 4>> edges,
                                std::span<double> values) { edge_answers_->of(edges, values); };
    const auto of = [this](const Corner& a, const Corner& b, const Corner& l, const Corner& r) {
      const std::array edge = {a, b, l, r};
      double value = 0;
      edge_answers_->of({&edge, 1}, {&value, 1});
      return value;
    };
    edge_measure_ = {name, of, needs_heights, of_many};
    objective_ = {direction, aggregate, edge_measure_};
    return;
  }
  answers_ = std::make_unique<Answers>(function_, name);
  triangle_measure_ = {
      name,
      [this](const Corner& a, const Corner& b, const Corner& c) { return answers_->of(a, b, c); },
      needs_heights};
  objective_ = {direction, aggregate, triangle_measure_};
}

OwnMeasure::~OwnMeasure() = default;

void OwnMeasure::prepare(const PointSet& points, Index order) const {
  if (answers_) answers_->prepare(points, order);
  if (edge_answers_) edge_answers_->prepare(points);
}

}  // namespace hodt::python
