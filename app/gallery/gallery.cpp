// hodt_gallery: draws the figures of docs/definitions.md. Point sets are picked by hand; circles,
// orders, hulls and edges are what the library says about them.
// Tested by tests/CMakeLists.txt.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <string_view>

#include "figures.h"
#include <fmt/format.h>

#include "hodt/io/atomic_write.h"

namespace {

struct Figure {
  std::string_view name;
  std::string (*draw)();
};

constexpr Figure kFigures[] = {
    {"orders", gallery::triangulation_orders},
    {"kod_edges", gallery::kod_edges},
    {"edge_order", gallery::edge_order},
    {"triangles", gallery::order_of_triangles},
    {"useful_edge", gallery::useful_edge},
    {"hull", gallery::hull},
    {"crossing_edges", gallery::crossing_edges},
    {"fixed_edges", gallery::fixed_edges},
    {"voronoi", gallery::voronoi},
    {"dam", gallery::artificial_dam},
    {"extrema_cycle", gallery::extrema_cycle},
    {"conflict_graph", gallery::conflict_graph},
    {"constrained_order", gallery::constrained_order},
    {"breaklines", gallery::breaklines},
};

void run(const std::filesystem::path& directory) {
  std::filesystem::create_directories(directory);
  for (const Figure& figure : kFigures) {
    const auto file = directory / fmt::format("{}.svg", figure.name);
    hodt::atomic_write(file, figure.draw());
    fmt::print("Wrote {}\n", file.string());
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 2) {
    fmt::print(stderr, "usage: hodt_gallery [OUTPUT_DIRECTORY]   (default: docs/gallery)\n");
    return 2;
  }
  try {
    run(argc == 2 ? argv[1] : "docs/gallery");
  } catch (const std::exception& error) {
    fmt::print(stderr, "hodt_gallery: {}\n", error.what());
    return 1;
  }
  return 0;
}
