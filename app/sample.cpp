// hodt sample: points of the built-in terrains.
// Tested by tests/app/command_test.cpp.
#include <algorithm>
#include <limits>

#include "app/common.h"
#include <fmt/format.h>

#include "hodt/base/parallel.h"
#include "hodt/io/atomic_write.h"
#include "hodt/io/point_file.h"
#include "hodt/terrain/terrain.h"

namespace hodt::app {

namespace {

struct Arguments {
  std::string name;
  std::string count;
  std::string seed = "1";
  std::string output = "-";
  std::string threads;
};

std::string terrain_list() {
  std::string text;
  for (const TerrainInfo& terrain : built_in_terrains()) {
    text += fmt::format("{:<12} {} (default: {})\n", terrain.name, terrain.description,
                        counted(terrain.default_points, "point"));
  }
  return text;
}

int run(const Arguments& arguments) {
  constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();
  const std::size_t count =
      arguments.count.empty() ? 0 : parse_whole("-n", arguments.count, 1, kNone - 1);
  const std::uint64_t seed = parse_whole("--seed", arguments.seed, 0, unlimited);
  const ThreadLimit limit(parse_threads(arguments.threads));
  if (arguments.name.empty()) {
    print(terrain_list());
    return kOk;
  }
  check_points_extension(arguments.output);
  check_targets({}, arguments.output, {});
  TerminalProgress progress;
  progress.report("sampling");
  const PointSet points = sample_terrain(arguments.name, count, seed);
  progress.report("writing");
  write_points(points, arguments.output);
  return kOk;
}

}  // namespace

void add_sample(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App& command = *app.add_subcommand("sample", "Write points of a built-in terrain");
  command.add_option("NAME", arguments->name, "Terrain; without it, the terrains are listed");
  command.add_option("-n", arguments->count, "Number of points (default: the terrain's)")
      ->type_name("N");
  command.add_option("--seed", arguments->seed, "Which points (default: 1)")->type_name("S");
  command
      .add_option("-o,--output", arguments->output,
                  "Write .csv or .xyz, also with .gz (default: CSV to standard output)")
      ->type_name("OUTPUT");
  add_threads(command, arguments->threads);
  command.footer(
      "Examples:\n"
      "  hodt sample\n"
      "  hodt sample valley -n 100000 --seed 7 -o valley.csv.gz");
  command.callback([arguments, &action] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace hodt::app
