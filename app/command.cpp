#include "app/command.h"

#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "app/common.h"
#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/base/printable.h"
#include "hodt/io/atomic_write.h"

namespace hodt::app {

namespace {

int complain(std::string message) {
  for (char& c : message) {
    if (c == '\n') c = ' ';
  }
  // Not fmt::print: that throws where standard error cannot be written.
  std::fputs(fmt::format("hodt: {}\n", printable(message)).c_str(), stderr);
  return kError;
}

/// CLI11 would only say that a subcommand is required.
void check_command_name(const CLI::App& app, int argc, const char* const* argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::string known;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == argv[1]) return;
    known += (known.empty() ? "" : ", ") + command->get_name();
  }
  throw ParameterError(fmt::format("there is no command '{}'; known are {}", argv[1], known));
}

/// "-k" of "-k,--order".
std::string short_name(const CLI::Option& option) {
  const std::vector<std::string>& letters = option.get_snames();
  return letters.empty() ? option.get_name() : "-" + letters.front();
}

/// An empty value would pass for an option that was not given.
void check_values(const CLI::App& app) {
  for (const CLI::App* command : app.get_subcommands())
    for (const CLI::Option* option : command->get_options())
      for (const std::string& value : option->results())
        if (value.empty())
          throw ParameterError(
              fmt::format("{} must be given a value, not ''", short_name(*option)));
}

/// Parses the command line into an action; help and version are actions too.
Action parse(CLI::App& app, int argc, const char* const* argv) {
  Action action;
  add_triangulate(app, action);
  add_check(app, action);
  add_info(app, action);
  add_sample(app, action);
  add_edges(app, action);
  add_triangles(app, action);
  add_voronoi(app, action);
  add_compare(app, action);
  add_contours(app, action);
  add_formats(app, action);
  add_raster(app, action);
  check_command_name(app, argc, argv);
  try {
    app.parse(argc, argv);
    check_values(app);
  } catch (const CLI::CallForHelp&) {
    const std::string help = app.help();
    return [help] { return print(help), kOk; };
  } catch (const CLI::CallForVersion& version) {
    const std::string text = fmt::format("{}\n", version.what());
    return [text] { return print(text), kOk; };
  }
  return action;
}

}  // namespace

int run(int argc, const char* const* argv) {
  CLI::App app("Higher order Delaunay triangulations: terrain meshes of controlled quality.",
               "hodt");
  app.set_version_flag("--version", "hodt " HODT_VERSION);
  app.require_subcommand(1);
  app.failure_message([](const CLI::App*, const CLI::Error& error) { return error.what(); });
  app.footer("'hodt COMMAND --help' explains a command, with examples.");
  try {
    return parse(app, argc, argv)();
  } catch (const CLI::ParseError& error) {
    const auto chosen = app.get_subcommands();
    return complain(fmt::format("{} (see 'hodt {}--help')", error.what(),
                                chosen.empty() ? "" : chosen[0]->get_name() + " "));
  } catch (const BrokenPipeError&) {
    return kOk;
  } catch (const std::bad_alloc&) {
    return complain("not enough memory");
  } catch (const std::exception& error) {
    return complain(error.what());
  }
}

}  // namespace hodt::app
