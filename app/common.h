// What the subcommands share.
// Tested by tests/app/faults_test.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "hodt/base/error.h"
#include "hodt/base/ids.h"
#include "hodt/base/printable.h"
#include "hodt/base/progress.h"
#include "hodt/base/stopwatch.h"
#include "hodt/geometry/point_set.h"
#include "hodt/io/input_text.h"
#include "hodt/tin/extrema.h"

namespace hodt::app {

/// Exit codes: a promise to users.
inline constexpr int kOk = 0;
inline constexpr int kNo = 1;     ///< `check` finds that the answer is no
inline constexpr int kError = 2;  ///< bad input or usage

/// Keys in the order of their insertion.
using Json = nlohmann::ordered_json;

/// What the chosen subcommand does; returns the exit code. Throws hodt::Error.
using Action = std::function<int()>;

/// Each adds a subcommand to the command line, and sets `action` when it is chosen.
void add_triangulate(CLI::App& app, Action& action);
void add_check(CLI::App& app, Action& action);
void add_info(CLI::App& app, Action& action);
void add_sample(CLI::App& app, Action& action);
void add_edges(CLI::App& app, Action& action);
void add_triangles(CLI::App& app, Action& action);
void add_voronoi(CLI::App& app, Action& action);
void add_compare(CLI::App& app, Action& action);
void add_contours(CLI::App& app, Action& action);
void add_formats(CLI::App& app, Action& action);
void add_raster(CLI::App& app, Action& action);

/// A whole number from an option's text. Throws ParameterError, naming the option, the text and the
/// range, if it is anything else.
std::uint64_t parse_whole(std::string_view option, const std::string& text, std::uint64_t least,
                          std::uint64_t most);

/// An order, k or m, as it was given. No set of points tells orders apart that an Index cannot
/// hold.
struct Order {
  Index limit = 0;
  std::string digits;
};
/// The order from an option's text, however large.
Order parse_order(const std::string& text, std::string_view option = "-k", Index least = 0);
Json to_json(const Order& order);

/// A finite number from an option's text. Throws ParameterError, naming both, if it is none.
double parse_number(std::string_view option, const std::string& text);
/// A number that is not negative from an option's text; empty is 0. Throws ParameterError, saying
/// that the option must be `what` ("a number of seconds").
double parse_non_negative(std::string_view option, std::string_view what, const std::string& text);
/// Seconds from --time-limit's text.
inline double parse_seconds(const std::string& text) {
  return parse_non_negative("--time-limit", "a number of seconds", text);
}

/// What f() returns. Of points that cannot be used the library knows all but where they come from:
/// its errors get the input's name.
template <class F>
auto naming(const std::string& input, const F& f) {
  try {
    return f();
  } catch (const InputError& error) {
    throw InputError(display_name(input) + ": " + error.what());
  } catch (const ParameterError& error) {
    throw ParameterError(display_name(input) + ": " + error.what());
  }
}

/// The option --threads, as text, with its description.
void add_threads(CLI::App& command, std::string& threads);
/// Its value for ThreadLimit.
std::size_t parse_threads(const std::string& text);

/// Writes lines of text to standard output, made printable. If nobody reads them any more, that is
/// no error.
void print(std::string_view lines);

/// A file's name in a report.
inline std::string shown(const std::filesystem::path& path) {
  return printable(path.string());
}

/// Throws ParameterError if the file that the option names is also one of the others that are
/// written; an empty one is none.
void check_other_outputs(std::string_view option, const std::string& file,
                         std::span<const std::string> others);

/// Throws if two of them name the same file, or a target cannot be written. An empty path is no
/// file.
void check_targets(const std::filesystem::path& input, const std::filesystem::path& output,
                   const std::filesystem::path& json);

Json to_json(const SplitCount& count);

/// A count as a whole number, anything else as it is.
Json to_json(double value);

/// "1 point", "2 points"; "1 minimum", "2 minima" if the plural is given.
std::string counted(std::size_t count, std::string_view thing, std::string_view things = {});

/// Says on the terminal what a long job is doing; says nothing if there is no terminal.
class TerminalProgress {
 public:
  TerminalProgress();
  ~TerminalProgress();
  void report(std::string_view phase, double fraction = -1);

 private:
  bool shown_ = false;
  std::unique_ptr<ProgressRelay> relay_;
};

}  // namespace hodt::app
