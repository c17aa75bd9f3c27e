// hodt check: is it a mesh, and of which order?
// Tested by tests/app/command_test.cpp.
#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "app/outputs.h"
#include <fmt/format.h>

#include "hodt/base/parallel.h"
#include "hodt/io/line_file.h"
#include "hodt/io/tin_file.h"
#include "hodt/pipeline/examine_mesh.h"

namespace hodt::app {

namespace {

struct Arguments {
  std::string tin;
  std::string order;
  bool strict = false;
  std::vector<std::string> breaklines;
  std::string threads;
  std::string json;
};

/// All that the command finds out.
struct Findings : MeshFindings {
  std::size_t points = 0;
  std::size_t triangles = 0;
};

using Edge = std::array<Index, 2>;

/// The pieces of the lines, as edges between vertices of the mesh.
std::vector<Edge> edges_of(const std::vector<std::string>& files, const Tin& tin) {
  std::vector<Edge> edges;
  if (files.empty()) return edges;
  std::map<std::pair<double, double>, Index> vertex_at;
  for (std::size_t v = 0; v < tin.points.size(); ++v)
    vertex_at.try_emplace({tin.points.xy[v].x, tin.points.xy[v].y}, static_cast<Index>(v));
  for (const std::string& file : files) {
    const Lines lines = read_lines(file);
    for (const Line& line : lines.lines) {
      Index last = kNone;
      for (const Point& p : line.xy) {
        const auto at = vertex_at.find({p.x, p.y});
        if (at == vertex_at.end())
          throw InputError(fmt::format("{}, {} {}: the mesh has no vertex at x {}, y {}",
                                       lines.source, lines.part, line.part, p.x, p.y));
        if (last != kNone && last != at->second) edges.push_back({last, at->second});
        last = at->second;
      }
    }
  }
  return edges;
}

Findings examine(Tin tin, std::vector<Edge> walls) {
  const std::size_t points = tin.points.size(), triangles = tin.triangles.size();
  return {examine_mesh(std::move(tin), std::move(walls)), points, triangles};
}

bool is_of_order(const Findings& findings, Index k) {
  return findings.order && findings.order->missing_walls == 0 && findings.order->order_plain <= k;
}

bool passes(const Findings& findings, const std::optional<Order>& k, bool strict) {
  const Embedding& embedding = findings.embedding;
  if (!embedding.embedded || findings.order->missing_walls > 0) return false;
  if (k && !is_of_order(findings, k->limit)) return false;
  return !strict || (embedding.covers_hull && embedding.unused_vertices == 0);
}

Json spread_json(const Spread& spread) {
  return {{"min", to_json(spread.min)},
          {"median", to_json(spread.median)},
          {"mean", to_json(spread.mean)},
          {"max", to_json(spread.max)}};
}

Json quality_json(const Quality& quality) {
  return {{"smallest_angle", spread_json(quality.smallest_angle)},
          {"largest_angle", spread_json(quality.largest_angle)},
          {"radius_ratio", spread_json(quality.radius_ratio)},
          {"aspect_ratio", spread_json(quality.aspect_ratio)},
          {"smallest_angles_from_0_by_10", quality.smallest_angles},
          {"largest_angles_from_60_by_10", quality.largest_angles}};
}

Json findings_json(const Findings& findings, const std::optional<Order>& k) {
  const Embedding& embedding = findings.embedding;
  Json json = {{"points", findings.points},
               {"triangles", findings.triangles},
               {"embedded", embedding.embedded},
               {"problem", nullptr},
               {"covers_hull", embedding.covers_hull},
               {"unused_vertices", embedding.unused_vertices},
               {"clockwise", embedding.clockwise},
               {"components", nullptr},
               {"boundary_edges", nullptr},
               {"order", nullptr},
               {"order_plain", nullptr},
               {"order_histogram", nullptr},
               {"missing_edges", nullptr},
               {"quality", nullptr}};
  if (!embedding.embedded) json["problem"] = embedding.problem;
  if (embedding.embedded) json["components"] = embedding.components;
  if (embedding.embedded) json["boundary_edges"] = embedding.boundary_edges;
  if (findings.order) json["missing_edges"] = findings.order->missing_walls;
  if (findings.order && findings.order->missing_walls == 0) {
    json["order"] = findings.order->order;
    json["order_plain"] = findings.order->order_plain;
    json["order_histogram"] = findings.order->histogram;
  }
  if (findings.quality) json["quality"] = quality_json(*findings.quality);
  if (k) {
    json["k"] = to_json(*k);
    json["k_od"] = is_of_order(findings, k->limit);
  }
  if (findings.extrema) {
    json["local_minima"] = to_json(findings.extrema->minima);
    json["local_maxima"] = to_json(findings.extrema->maxima);
    json["pits"] = to_json(findings.extrema->pits);
  }
  return json;
}

std::string histogram_line(const MeshOrder& order) {
  std::string text = fmt::format("{:<16}", "triangles of");
  for (std::size_t i = 0; i < order.histogram.size(); ++i) {
    if (order.histogram[i] > 0) text += fmt::format(" order {}: {};", i, order.histogram[i]);
  }
  text.back() = '\n';
  return text;
}

std::string spread_line(std::string_view name, const Spread& spread) {
  return fmt::format("  {:<16} {:>10.4g} {:>10.4g} {:>10.4g} {:>10.4g}\n", name, spread.min,
                     spread.median, spread.mean, spread.max);
}

/// Of a histogram of angles the shares, in percent.
template <std::size_t bins>
std::string angles_line(std::string_view name, const std::array<std::size_t, bins>& counts,
                        std::size_t from, std::size_t triangles) {
  std::string text = fmt::format("  {:<16}", name);
  for (std::size_t i = 0; i < bins; ++i) {
    if (counts[i] == 0) continue;
    const std::size_t low = from + i * Quality::kBinWidth;
    text += fmt::format(" {}-{}°: {:.1f} %;", low, low + Quality::kBinWidth,
                        100 * double(counts[i]) / double(triangles));
  }
  text.back() = '\n';
  return text;
}

std::string quality_text(const Quality& quality, std::size_t triangles) {
  return fmt::format("{:<18} {:>10} {:>10} {:>10} {:>10}\n", "quality", "min", "median", "mean",
                     "max") +
         spread_line("smallest angle", quality.smallest_angle) +
         spread_line("largest angle", quality.largest_angle) +
         spread_line("radius ratio", quality.radius_ratio) +
         spread_line("aspect ratio", quality.aspect_ratio) +
         angles_line("smallest angles", quality.smallest_angles, 0, triangles) +
         angles_line("largest angles", quality.largest_angles, 60, triangles);
}

std::string summary(const Findings& findings, const std::optional<Order>& k) {
  const Embedding& embedding = findings.embedding;
  std::string text = fmt::format("{:<16} {}, {}\n", "mesh", counted(findings.points, "point"),
                                 counted(findings.triangles, "triangle"));
  if (!embedding.embedded)
    return text + fmt::format("{:<16} no: {}\n", "embedded", embedding.problem);
  text += fmt::format("{:<16} yes, {}\n", "embedded", counted(embedding.components, "component"));
  text += fmt::format("{:<16} {}\n", "covers the hull", embedding.covers_hull ? "yes" : "no");
  text += fmt::format("{:<16} {}\n", "unused vertices", embedding.unused_vertices);
  if (const std::size_t missing = findings.order->missing_walls; missing > 0) {
    text += fmt::format("{:<16} no: {} missing\n", "has the lines",
                        counted(missing, "edge is", "edges are"));
  } else {
    text += fmt::format("{:<16} {} (ties perturbed: {})\n", "order", findings.order->order_plain,
                        findings.order->order);
    text += histogram_line(*findings.order);
  }
  if (k)
    text += fmt::format("order {} or less  {}\n", k->digits,
                        is_of_order(findings, k->limit) ? "yes" : "no");
  if (findings.extrema) {
    const auto& [minima, maxima, pits] = *findings.extrema;
    for (const auto& [name, count] :
         {std::pair("local minima", minima), {"local maxima", maxima}, {"pits", pits}}) {
      text += fmt::format("{:<16} {} (interior {}, boundary {})\n", name, count.total(),
                          count.interior, count.boundary);
    }
  }
  if (findings.triangles > 0) text += quality_text(*findings.quality, findings.triangles);
  return text;
}

int run(const Arguments& arguments) {
  std::optional<Order> k;
  if (!arguments.order.empty()) k = parse_order(arguments.order);
  const ThreadLimit limit(parse_threads(arguments.threads));
  check_targets(arguments.tin, {}, arguments.json);
  Findings findings;
  {
    TerminalProgress progress;
    progress.report("reading");
    Tin tin = read_tin(arguments.tin);
    progress.report("checking");
    std::vector<Edge> walls = edges_of(arguments.breaklines, tin);
    findings = naming(arguments.tin, [&] { return examine(std::move(tin), std::move(walls)); });
  }
  Outputs outputs;
  outputs.write_json(findings_json(findings, k), arguments.json);
  outputs.commit(summary(findings, k));
  return passes(findings, k, arguments.strict) ? kOk : kNo;
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App& command =
      *app.add_subcommand("check", "Check a mesh: is it embedded, and of which order?");
  command.add_option("TIN", arguments->tin, "Mesh: .obj or .ply, also .gz; - is standard input")
      ->required();
  command.add_option("-k,--order", arguments->order, "Require this order or less")->type_name("K");
  command.add_flag("--strict", arguments->strict,
                   "Require also that it covers the convex hull with no vertex unused");
  command
      .add_option("--breaklines", arguments->breaklines,
                  "Require the edges of these lines (GeoJSON), whose vertices are the mesh's,\n"
                  "and count no point beyond them; repeatable")
      ->type_name("FILE");
  add_threads(command, arguments->threads);
  command.add_option("--json", arguments->json, "Write the findings as JSON; - is standard output")
      ->type_name("FILE");
  command.footer(
      "Quality is that of the triangles in (x, y): angles in degrees; the radius ratio, twice the\n"
      "inradius by the circumradius, is 1 for an equilateral triangle and 0 for a sliver; the\n"
      "aspect ratio is the longest edge by its height, 1 for an equilateral triangle.\n"
      "Points beyond the mesh's own border or its holes do not count for the order.\n"
      "Exit status: 0 if the mesh is as required, 1 if not, 2 for bad input or usage.\n"
      "Examples:\n"
      "  hodt check terrain.ply\n"
      "  hodt check terrain.ply -k 4 --strict --json -");
  command.callback([arguments, &action] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace hodt::app
