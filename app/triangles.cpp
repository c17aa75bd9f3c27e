// hodt triangles: all triangles of a class, with their orders.
#include "hodt/order/triangles.h"

#include <array>

#include "app/record_lists.h"
#include <fmt/format.h>

#include "hodt/base/error.h"

namespace hodt::app {

namespace {

TriangleClass class_of(const std::string& name) {
  if (name == "valid") return TriangleClass::valid;
  if (name == "kod") return TriangleClass::kod;
  throw ParameterError(fmt::format("--class must be valid or kod, not '{}'", name));
}

int run(const ListArguments& arguments) {
  const TriangleClass triangle_class = class_of(arguments.list_class);
  return write_list(
      arguments, "a,b,c,order", "triangles",
      [&](const DelaunayGraph& graph, Index k, const Numbering& numbering, CsvLines& lines) {
        for_each_triangle(graph, triangle_class, k, numbering,
                          [&](std::span<const TriangleRecord> records) {
                            for (const auto& [a, b, c, order] : records)
                              lines.add(std::array{a, b, c, order});
                          });
      });
}

}  // namespace

void add_triangles(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<ListArguments>();
  arguments->list_class = "valid";
  CLI::App& command =
      *app.add_subcommand("triangles", "List the triangles of a class, with their orders");
  add_list_options(command, *arguments,
                   "valid (default): empty, and with three edges useful for K;\n"
                   "kod: any three points whose circle holds at most K others");
  command.footer(
      "Writes a,b,c,order with a < b < c, sorted. The order is the number of points in the "
      "circle;\n"
      "for valid the edges' useful orders count too, if they are larger.\n"
      "Examples:\n"
      "  hodt triangles points.csv -k 4 -o valid.csv\n"
      "  hodt triangles points.csv -k 1 --class kod -o -");
  command.callback([arguments, &action] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace hodt::app
