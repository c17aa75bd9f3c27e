#include "hodt/pipeline.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"
#include "hodt/base/stopwatch.h"
#include "hodt/delaunay/delaunay.h"
#include "hodt/optimize/optimize.h"
#include "hodt/optimize/value_of.h"
#include "hodt/order/change_problem.h"
#include "hodt/order/delaunay_graph.h"
#include "hodt/order/triangulation_order.h"
#include "hodt/pipeline/constrain.h"
#include "hodt/pipeline/given_tin.h"

namespace hodt {

namespace {

bool asks_to_keep(const TriangulateOptions& options) {
  return options.min_pit_depth > 0 || !options.keep.empty();
}

bool tells_orders(const TriangulateOptions& options) {
  return options.tell_orders || options.tell_changes;
}

/// The first counts most.
std::vector<Objective> objectives_of(const TriangulateOptions& options) {
  std::vector<Objective> objectives{options.objective};
  objectives.insert(objectives.end(), options.then.begin(), options.then.end());
  return objectives;
}

/// Before any work is done.
void check(const PointSet& points, const TriangulateOptions& options) {
  const std::vector<Objective> objectives = objectives_of(options);
  check_objectives(objectives);
  for (const Objective& objective : objectives) {
    check_heights(objective, points.has_heights());
    check_method(options.method, objective);
  }
}

void check_keeps(const TriangulateOptions& options) {
  if (asks_to_keep(options) && !counts_minima(options.objective))
    throw ParameterError(fmt::format(
        "minima to keep are for objectives that remove minima{}; {} is not one",
        options.then.empty() ? "" : ", of several the first", name_of(options.objective)));
}

/// Vertex numbers of the output: input order, dropped duplicates left out.
class OutputNumbering {
 public:
  OutputNumbering(const VertexSet& vertices, std::size_t rows)
      : of_row_(rows, kNone), of_vertex_(vertices.size()) {
    for (const Index row : vertices.row) of_row_[row] = 0;
    Index next = 0;
    for (Index& number : of_row_)
      if (number != kNone) number = next++;
    count_ = next;
    parallel_for(0, vertices.size(), 1 << 15, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v) of_vertex_[v] = of_row_[vertices.row[v]];
    });
  }
  /// Of the rows that have a number.
  std::size_t count() const { return count_; }
  std::span<const Index> of_vertices() const { return of_vertex_; }
  bool is_kept(std::size_t row) const { return of_row_[row] != kNone; }
  Index operator[](VertexId v) const { return of_vertex_[v]; }

 private:
  Buffer<Index> of_row_, of_vertex_;
  std::size_t count_ = 0;
};

std::vector<std::array<Index, 3>> triangle_list(const TriangleMesh& mesh,
                                                const OutputNumbering& numbering) {
  std::vector<std::array<Index, 3>> triangles(mesh.triangle_count());
  parallel_for(0, triangles.size(), 1 << 15, [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) {
      const auto [a, b, c] = mesh.corners(TriangleId(Index(t)));
      triangles[t] = {numbering[a], numbering[b], numbering[c]};
    }
  });
  return triangles;
}

PointSet kept_points(const PointSet& points, const OutputNumbering& numbering) {
  if (numbering.count() == points.size()) return points;
  PointSet kept;
  kept.crs = points.crs;
  for (std::size_t row = 0; row < points.size(); ++row) {
    if (!numbering.is_kept(row)) continue;
    kept.xy.push_back(points.xy[row]);
    if (points.has_heights()) kept.z.push_back(points.z[row]);
  }
  return kept;
}

ExtremaCount extrema_of(const TriangleMesh& mesh, const VertexSet& vertices, const PointSet& points,
                        const Report& report) {
  if (report.constraints.triangles_outside + report.constraints.triangles_too_long == 0)
    return count_extrema(vertices.xy, vertices.z, mesh.origins());
  // Where a domain touches itself, two vertices are the same point.
  std::vector<Index> rows;
  rows.reserve(mesh.halfedge_count());
  for (const Index v : mesh.origins()) rows.push_back(vertices.row[v]);
  return count_extrema(points.xy, points.z, rows);
}

[[noreturn]] void throw_defect(const std::string& what) {
  throw std::logic_error(what +
                         "; this is a defect of hodt, please report it with the input and options");
}

/// A mesh in place of the Delaunay triangulation is not trusted. (Flips are told one by one, each
/// in its quadrilateral, and cannot spoil it.)
void verify_mesh(const DelaunayGraph& graph, const MeshChange& change) {
  if (change.mesh() == nullptr) return;
  const std::string problem = change_problem(graph, *change.mesh());
  if (!problem.empty()) throw_defect("the result is no triangulation of the points: " + problem);
}

/// What is known without an objective of a triangulation that was there already.
Report::Given look_at_given(const DelaunayGraph& graph, const TriangleMesh& given) {
  if (const std::string problem = change_problem(graph, given); !problem.empty())
    throw InputError("the triangles given are no triangulation of the domain: " + problem);
  return {static_cast<Index>(order_histogram(graph, given).size() - 1), 0, {}, false};
}

/// Whether what was there is better than what was found, by the first objective that can tell.
bool beats(const TriangulateOptions& options, const Report::Given& given,
           const OrderedOptimum& found) {
  if (given.value != found.value.result)
    return is_better(options.objective, given.value, found.value.result);
  for (std::size_t i = 0; i < options.then.size(); ++i)
    if (const double result = found.then[i].value.result; given.then[i] != result)
      return is_better(options.then[i], given.then[i], result);
  return false;
}

/// Compares what was there already; takes it if it is better than what was found.
void compare_with_given(const DelaunayGraph& graph, std::span<const double> z,
                        const TriangleMesh& given, const MinimaToKeep& keep,
                        const TriangulateOptions& options, OrderedOptimum& optimum,
                        Report& report) {
  report.given->value = value_of(options.objective, given, graph.xy, z);
  for (const Objective& objective : options.then)
    report.given->then.push_back(value_of(objective, given, graph.xy, z));
  if (keep.count > 0) return;  // it need not have the minima that are to stay
  if (report.given->order > options.order || !beats(options, *report.given, optimum)) return;
  report.given->is_kept = true;
  optimum.change = MeshChange(given);
  const auto take = [](double given_value, Value& value) {
    value.result = given_value;
    value.optimal = value.result == value.bound;
  };
  take(report.given->value, optimum.value);
  for (std::size_t i = 0; i < optimum.then.size(); ++i)
    take(report.given->then[i], optimum.then[i].value);
}

/// Fills what the report says of the orders; returns those of the triangles, if they are to be
/// told.
std::vector<Index> count_orders(const DelaunayGraph& graph, const MeshChange& change,
                                const TriangulateOptions& options, Report& report) {
  std::vector<Index> orders;
  if (tells_orders(options)) orders = triangle_orders(graph, change);
  report.order_histogram =
      tells_orders(options) ? order_histogram(orders) : order_histogram(graph, change);
  report.order = static_cast<Index>(report.order_histogram.size() - 1);
  if (report.order > options.order)
    throw_defect(fmt::format("a triangle is of order {} where {} was asked for", report.order,
                             options.order));
  return orders;
}

/// Optimises a Delaunay triangulation, and verifies the result; fills what the report says of it.
/// Returns the orders of the triangles, if they are to be told.
std::vector<Index> optimize_and_verify(Delaunay& delaunay, const MinimaToKeep& keep,
                                       const std::optional<TriangleMesh>& given,
                                       const TriangulateOptions& options, Report& report) {
  const Deadline deadline(options.time_limit);
  DelaunayGraph graph(delaunay);
  if (options.order > 1) graph.list_neighbours_if_hubs(deadline);
  OrderedOptimum optimum = optimize_in_order(graph, delaunay.vertices.z, objectives_of(options),
                                             {.order = options.order,
                                              .method = options.method,
                                              .deadline = deadline,
                                              .keep = keep.is_kept,
                                              .progress = options.progress});
  if (options.progress) options.progress("verification", -1);
  if (report.given)
    compare_with_given(graph, delaunay.vertices.z, *given, keep, options, optimum, report);
  verify_mesh(graph, optimum.change);
  std::vector<Index> orders = count_orders(graph, optimum.change, options, report);
  report.value = optimum.value;
  report.then = std::move(optimum.then);
  std::move(optimum.change).apply_to(delaunay.mesh);
  return orders;
}

}  // namespace

Prepared prepare(const PointSet& points, const TriangulateOptions& options,
                 const Constraints& constraints) {
  if (asks_to_keep(options) && !points.has_heights())
    throw ParameterError("minima to keep need heights, and the points have none; add a z column");
  Stopwatch watch;
  if (options.progress) options.progress("Delaunay triangulation", -1);
  Prepared prepared{delaunay(points), {}, {}, {}};
  const VertexSet& vertices = prepared.delaunay.vertices;
  const TriangleMesh& mesh = prepared.delaunay.mesh;
  Report& report = prepared.report;
  report.points = points.size();
  report.duplicates = points.size() - vertices.size();
  if (!constraints.empty()) {
    if (options.progress) options.progress("constraints", -1);
    report.constraints = constrain(prepared.delaunay, points, constraints);
    if (!constraints.triangles.empty()) {
      prepared.given = mesh_of_given(prepared.delaunay, points, constraints.triangles);
      report.given = look_at_given(DelaunayGraph(prepared.delaunay), *prepared.given);
    }
  }
  report.seconds.delaunay = watch.lap();
  report.triangles = mesh.triangle_count();
  report.order_histogram = {report.triangles};
  if (points.has_heights()) {
    report.duplicate_heights = vertices.duplicate_heights;
    report.extrema_delaunay = report.extrema_result = extrema_of(mesh, vertices, points, report);
  }
  if (asks_to_keep(options)) {
    watch.lap();
    if (options.progress) options.progress("minima to keep", -1);
    prepared.keep = minima_to_keep(DelaunayGraph(prepared.delaunay), vertices.z,
                                   options.min_pit_depth, options.keep);
    report.seconds.optimize = watch.lap();
  }
  return prepared;
}

TriangulateResult triangulate(const PointSet& points, Prepared prepared,
                              const TriangulateOptions& options) {
  check(points, options);
  TriangulateResult result{{}, std::move(prepared.report)};
  Report& report = result.report;
  Delaunay& delaunay = prepared.delaunay;
  const VertexSet& vertices = delaunay.vertices;
  report.k = options.order;
  report.objective = options.objective;
  if (counts_minima(options.objective)) {
    report.kept = prepared.keep.count;
    report.empty_polygons = prepared.keep.empty_polygons;
  }

  Stopwatch watch;
  if (options.tell_delaunay)
    report.delaunay = triangle_list(delaunay.mesh, OutputNumbering(vertices, points.size()));
  TriangleMesh before;
  if (options.tell_changes) before = delaunay.mesh;
  if (options.objective != Objective::none) {
    result.tin.order =
        optimize_and_verify(delaunay, prepared.keep, prepared.given, options, report);
    report.seconds.optimize += watch.lap();
    if (points.has_heights())
      report.extrema_result = extrema_of(delaunay.mesh, vertices, points, report);
  } else if (tells_orders(options)) {
    result.tin.order.assign(delaunay.mesh.triangle_count(), 0);
  }
  if (options.measure_pits && points.has_heights())
    report.pits = pit_totals(delaunay.mesh, vertices.xy, vertices.z);

  watch.lap();
  const OutputNumbering numbering(vertices, points.size());
  result.tin.triangles = triangle_list(delaunay.mesh, numbering);
  report.seconds.delaunay += watch.lap();
  result.tin.points = kept_points(points, numbering);
  result.tin.crs = points.crs;
  if (options.tell_changes)
    report.changes = what_changed(before, delaunay.mesh, vertices, prepared.keep, result.tin.order,
                                  numbering.of_vertices());
  return result;
}

TriangulateResult triangulate(const PointSet& points, const TriangulateOptions& options,
                              const Constraints& constraints) {
  check(points, options);
  check_keeps(options);
  return triangulate(points, prepare(points, options, constraints), options);
}

}  // namespace hodt
