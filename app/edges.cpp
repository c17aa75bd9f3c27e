// hodt edges: all edges of a class, with their orders.
#include "hodt/order/edges.h"

#include <array>

#include "app/record_lists.h"
#include <fmt/format.h>

#include "hodt/base/error.h"

namespace hodt::app {

namespace {

EdgeClass class_of(const std::string& name) {
  if (name == "useful") return EdgeClass::useful;
  if (name == "kod") return EdgeClass::kod;
  if (name == "fixed") return EdgeClass::fixed;
  if (name == "delaunay") return EdgeClass::delaunay;
  throw ParameterError(
      fmt::format("--class must be useful, kod, fixed or delaunay, not '{}'", name));
}

int run(const ListArguments& arguments) {
  const EdgeClass edge_class = class_of(arguments.list_class);
  return write_list(
      arguments, "u,v,order", "edges",
      [&](const DelaunayGraph& graph, Index k, const Numbering& numbering, CsvLines& lines) {
        for_each_edge(graph, edge_class, k, numbering, [&](std::span<const EdgeRecord> records) {
          for (const auto& [u, v, order] : records) lines.add(std::array{u, v, order});
        });
      });
}

}  // namespace

void add_edges(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<ListArguments>();
  arguments->list_class = "useful";
  CLI::App& command = *app.add_subcommand("edges", "List the edges of a class, with their orders");
  add_list_options(command, *arguments,
                   "useful (default): in some triangulation of order K;\n"
                   "kod: some circle through both ends holds at most K points;\n"
                   "fixed: in every triangulation of order K;\n"
                   "delaunay: in the Delaunay triangulation");
  command.footer(
      "Writes u,v,order with u < v, sorted. The order is the useful order; for kod the least "
      "number\n"
      "of points in a circle through both ends.\n"
      "Examples:\n"
      "  hodt edges points.csv -k 4 -o useful.csv\n"
      "  hodt edges points.csv -k 8 --class fixed -o fixed.csv\n"
      "  hodt sample valley -n 1000 | hodt edges - -k 2 --class kod -o -");
  command.callback([arguments, &action] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace hodt::app
