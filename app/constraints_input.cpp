#include "app/constraints_input.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "app/layer_file.h"
#include "app/points_input.h"
#include "app/warning.h"
#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/edge_pairs_file.h"
#include "hodt/io/formats.h"
#include "hodt/io/line_file.h"
#include "hodt/mesh/edge_list.h"
#include "hodt/pipeline/constrain.h"

namespace hodt::app {

namespace {

/// Each edge as a line of its own, so that errors can name it; returns where they come from.
std::vector<Joined::Origin> add_source(std::span<const Constraints::Edge> edges,
                                       const std::string& name, const std::string& part,
                                       Joined& joined) {
  std::vector<Joined::Origin> origins;
  Lines source{{}, name, part};
  for (Index i = 0; i < edges.size(); ++i) {
    const auto& [u, v] = edges[i];
    source.lines.push_back({{joined.points.xy[u], joined.points.xy[v]}, {}, i + 1});
    origins.push_back({static_cast<Index>(joined.sources.size()), i, 0});
  }
  joined.sources.push_back(std::move(source));
  return origins;
}

/// Edges between rows of the points, or vertices of a mesh, by the file that lists them.
void add_edge_pairs(const std::string& file, const std::string& input, Joined& joined,
                    std::size_t rows, std::span<const Index> numbers) {
  EdgePairs pairs = read_edge_pairs(file);
  const bool is_mesh = !numbers.empty();
  if (is_mesh) rows = numbers.size();
  for (std::size_t i = 0; i < pairs.edges.size(); ++i)
    for (Index& row : pairs.edges[i]) {
      if (row >= rows)
        throw InputError(
            fmt::format("{}: there is no {} {} in {}, which has {}, counted from 0", pairs.place(i),
                        is_mesh ? "vertex" : "row", row, display_name(input),
                        is_mesh ? counted(rows, "vertex", "vertices") : counted(rows, "row")));
      if (!is_mesh) continue;
      if (numbers[row] == kNone)
        throw InputError(fmt::format("{}: vertex {} of {} is left out, as no triangle has it",
                                     pairs.place(i), row, display_name(input)));
      row = numbers[row];
    }
  std::vector<Constraints::Edge>& edges = joined.constraints.edges;
  // After the other breaklines, before the boundary.
  const std::vector<Joined::Origin> origins = add_source(pairs.edges, pairs.source, "edge", joined);
  joined.origins.insert(joined.origins.begin() + std::ptrdiff_t(edges.size()), origins.begin(),
                        origins.end());
  edges.insert(edges.end(), pairs.edges.begin(), pairs.edges.end());
}

/// Whether the triangles have all of these edges.
bool has_edges(std::span<const std::array<Index, 3>> triangles,
               std::span<const Constraints::Edge> edges) {
  if (edges.empty()) return true;
  const std::vector<Constraints::Edge> all = sorted_edges(triangles, [](Index v) { return v; });
  return std::all_of(edges.begin(), edges.end(), [&](const Constraints::Edge& e) {
    return e[0] == e[1] || has_edge(all, e[0], e[1]);
  });
}

/// Whether the edges to keep are lines, and no table.
bool keeps_lines(const ConstraintArguments& arguments) {
  return !arguments.keep_edges.empty() &&
         find_format(layer_file(arguments.keep_edges).file, Use::read_features);
}

bool has_lines(const ConstraintArguments& arguments) {
  return !arguments.breaklines.empty() || !arguments.outline.empty() || keeps_lines(arguments);
}

}  // namespace

void add_constraints(CLI::App& command, ConstraintArguments& arguments) {
  command
      .add_option("--breaklines", arguments.breaklines,
                  "Lines (GeoJSON, GeoPackage, Shapefile, ...) that no triangle crosses, in the\n"
                  "coordinate system of INPUT; repeatable. Those without heights take them from\n"
                  "the surface. Of several layers one is named like roads.gpkg|layername=paved")
      ->allow_extra_args(false)
      ->type_name("FILE");
  command
      .add_option("--outline", arguments.outline,
                  "Polygons (of the same formats) that bound the triangulation, with holes")
      ->type_name("FILE");
  command
      .add_option("--max-edge", arguments.max_edge,
                  "Take away triangles at the boundary with a longer edge there")
      ->type_name("LENGTH");
  command
      .add_option("--keep-edges", arguments.keep_edges,
                  "Edges that stay: a table of pairs of rows of INPUT, counted from 0 (as\n"
                  "`hodt edges` writes it), or lines")
      ->type_name("FILE");
  command.add_flag("--split-crossings", arguments.split_crossings,
                   "Add a vertex where lines cross, which is an error otherwise");
  command
      .add_option("--snap", arguments.snap,
                  "Move vertices of lines to the nearest point, if it is no further than this")
      ->type_name("D");
}

void check_constraints(const ConstraintArguments& arguments, const std::string& input,
                       const std::string& output, const std::string& json) {
  parse_non_negative("--max-edge", "a length", arguments.max_edge);
  parse_non_negative("--snap", "a distance", arguments.snap);
  if ((arguments.split_crossings || !arguments.snap.empty()) && !has_lines(arguments))
    throw ParameterError(
        fmt::format("{} is for lines, and there are none; add --breaklines or --outline",
                    arguments.split_crossings ? "--split-crossings" : "--snap"));
  std::vector<std::string> files = arguments.breaklines;
  files.push_back(arguments.outline);
  files.push_back(arguments.keep_edges);
  for (const std::string& file : files) {
    if (input == "-" && file == "-")
      throw ParameterError("INPUT and a file of constraints cannot both be standard input");
    check_targets(layer_file(file).file, output, json);
  }
}

Joined read_constraints(const ConstraintArguments& arguments, const std::string& input,
                        CommonSystem& system, PointSet points, std::span<const Index> numbers,
                        std::span<const std::array<Index, 3>> surface) {
  std::vector<Lines> lines;
  const auto add_lines = [&](const std::string& name) {
    const auto [file, layer] = layer_file(name);
    lines.push_back(read_lines(file, layer));
    system.add(lines.back().source, lines.back().crs);
  };
  for (const std::string& file : arguments.breaklines) add_lines(file);
  if (keeps_lines(arguments)) add_lines(arguments.keep_edges);
  std::optional<Outline> outline;
  if (!arguments.outline.empty()) {
    const auto [file, layer] = layer_file(arguments.outline);
    outline = read_outline(file, layer);
    system.add(outline->source, outline->crs);
  }
  JoinOptions options{arguments.split_crossings,
                      parse_non_negative("--snap", "a distance", arguments.snap), surface};
  const std::size_t rows = points.size();
  Joined joined;
  if (lines.empty() && !outline)
    joined.points = std::move(points);
  else
    joined = join_lines(points, lines, outline, options);
  if (!arguments.keep_edges.empty() && !keeps_lines(arguments))
    add_edge_pairs(arguments.keep_edges, input, joined, rows, numbers);
  if (!arguments.max_edge.empty())
    joined.constraints.max_edge = parse_non_negative("--max-edge", "a length", arguments.max_edge);
  return joined;
}

void print_warnings(const Joined& joined) {
  for (const Lines& source : joined.sources)
    for (const std::string& warning : source.warnings) print_warning(source.source, warning);
}

void add_given(Constraints& given, const std::string& input, Joined& joined) {
  Constraints& constraints = joined.constraints;
  if (!constraints.boundary.empty() || !std::isinf(constraints.max_edge))
    throw ParameterError("the outline of " + display_name(input) +
                         " stays; leave out --outline and --max-edge");
  const std::vector<Joined::Origin> origins =
      add_source(given.boundary, display_name(input), "boundary edge", joined);
  joined.origins.insert(joined.origins.end(), origins.begin(), origins.end());
  constraints.boundary = std::move(given.boundary);
  // With another edge than its own the mesh itself is no triangulation to compare with.
  if (has_edges(given.triangles, constraints.edges))
    constraints.triangles = std::move(given.triangles);
}

void naming_lines(const std::string& input, const Joined& joined, const std::function<void()>& f) {
  std::string crossing;
  const auto run = [&] {
    try {
      f();
    } catch (const CrossingError& error) {
      crossing = crossing_text(joined, error.crossings().front());
      if (const std::size_t more = error.crossings().size() - 1; more > 0)
        crossing += fmt::format("; so do {}", counted(more, "more pair"));
      throw;
    }
  };
  try {
    naming(input, run);
  } catch (const InputError&) {
    if (crossing.empty()) throw;
    throw InputError(
        crossing +
        "; mend them, or add --split-crossings for a vertex where lines cross (not where "
        "they cross edges to keep or the outline of a mesh)");
  }
}

TriangulateResult triangulate_joined(const std::string& input, const Joined& joined,
                                     const TriangulateOptions& options) {
  TriangulateResult result;
  naming_lines(input, joined,
               [&] { result = triangulate(joined.points, options, joined.constraints); });
  return result;
}

JoinedDelaunay delaunay_of_joined(const std::string& input, const Joined& joined) {
  JoinedDelaunay result;
  naming_lines(input, joined, [&] {
    result.triangulation = delaunay(joined.points);
    result.duplicates = joined.points.size() - result.triangulation.vertices.size();
    result.constraints = constrain(result.triangulation, joined.points, joined.constraints);
  });
  return result;
}

std::string constraints_text(const JoinReport& joined, const ConstraintReport& report, int indent) {
  const std::string lines = report.edges == 0 ? "no lines"
                                              : fmt::format("{} of lines, {} of the triangulation",
                                                            counted(report.edges, "piece"),
                                                            counted(report.walls, "edge"));
  std::string text = fmt::format("{:<{}} {}\n", "constraints", indent, lines);
  const auto line = [&](std::string_view what) {
    text += fmt::format("{:<{}} {}\n", "", indent, what);
  };
  if (joined.added + joined.at_points > 0)
    line(fmt::format("vertices of lines: {} added, {} at points", joined.added, joined.at_points));
  if (joined.snapped > 0)
    line(fmt::format("{} of them moved to a point{}", joined.snapped,
                     joined.collapsed == 0
                         ? ""
                         : fmt::format(", and {} with both ends to the same one: gone",
                                       counted(joined.collapsed, "piece"))));
  if (joined.soft > 0) line(fmt::format("{} took their heights from the surface", joined.soft));
  if (joined.heights_replaced > 0)
    line(fmt::format("{} of points replaced by those of lines, by {} at most",
                     counted(joined.heights_replaced, "height"), joined.largest_replacement));
  if (joined.heights_in_conflict > 0)
    line(fmt::format("{} given twice, by up to {} apart; the first one counts",
                     counted(joined.heights_in_conflict, "height"), joined.largest_conflict));
  if (joined.heights_passed > 0)
    line(fmt::format("{} that lines pass through stay, by up to {} beside the line",
                     counted(joined.heights_passed, "height"), joined.largest_passed));
  if (joined.crossings > 0)
    line(fmt::format("{} added where lines cross; their heights differ by {} at most",
                     counted(joined.crossings, "vertex", "vertices"),
                     joined.largest_crossing_difference));
  const std::size_t left_out = report.triangles_outside + report.triangles_too_long;
  if (left_out > 0)
    line(fmt::format(
        "left out: {} outside, {} with too long an edge, {}{}",
        counted(report.triangles_outside, "triangle"), report.triangles_too_long,
        counted(report.unused_points, "point"),
        report.walls_left_out == 0
            ? ""
            : ", " + counted(report.walls_left_out, "edge of lines", "edges of lines")));
  return text;
}

Json constraints_json(const JoinReport& joined, const ConstraintReport& report) {
  return {{"edges", report.edges},
          {"edges_kept", report.walls},
          {"vertices_added", joined.added + joined.crossings},
          {"vertices_at_points", joined.at_points},
          {"vertices_snapped", joined.snapped},
          {"pieces_snapped_away", joined.collapsed},
          {"vertices_from_surface", joined.soft},
          {"vertices_at_crossings", joined.crossings},
          {"largest_difference_at_crossings", joined.largest_crossing_difference},
          {"heights_replaced", joined.heights_replaced},
          {"largest_replacement", joined.largest_replacement},
          {"heights_in_conflict", joined.heights_in_conflict},
          {"largest_conflict", joined.largest_conflict},
          {"heights_passed", joined.heights_passed},
          {"largest_passed", joined.largest_passed},
          {"triangles_outside", report.triangles_outside},
          {"triangles_too_long", report.triangles_too_long},
          {"points_left_out", report.unused_points},
          {"edges_left_out", report.walls_left_out}};
}

}  // namespace hodt::app
