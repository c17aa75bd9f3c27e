#include "app/common.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "hodt/base/error.h"
#include "hodt/io/atomic_write.h"

namespace hodt::app {

std::uint64_t parse_whole(std::string_view option, const std::string& text, std::uint64_t least,
                          std::uint64_t most) {
  const auto is_digit = [](char c) { return '0' <= c && c <= '9'; };
  if (text.empty() || !std::all_of(text.begin(), text.end(), is_digit)) {
    throw ParameterError(
        fmt::format("{} must be a whole number of at least {}, not '{}'", option, least, text));
  }
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || value > most) value = most;
  if (value < least) {
    throw ParameterError(fmt::format("{} must be at least {}, not '{}'", option, least, text));
  }
  return value;
}

Index parse_order(const std::string& text) {
  return static_cast<Index>(parse_whole("-k", text, 0, kNone - 1));
}

double parse_non_negative(std::string_view option, std::string_view what, const std::string& text) {
  if (text.empty()) return 0;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  if (!is_number || !std::isfinite(value) || value < 0)
    throw ParameterError(fmt::format("{} must be {}, not '{}'", option, what, text));
  return value;
}

void add_threads(CLI::App& command, std::string& threads) {
  command.add_option("--threads", threads, "Threads that may compute (default: all cores)")
      ->type_name("T");
}

std::size_t parse_threads(const std::string& text) {
  if (text.empty()) return 0;
  constexpr std::size_t more_than_any_machine_has = 4096;
  return parse_whole("--threads", text, 1, more_than_any_machine_has);
}

void print(std::string_view text) {
  try {
    atomic_write("-", text);
  } catch (const BrokenPipeError&) {
    // `hodt ... | head` has seen enough.
  }
}

void write_json(const Json& json, const std::filesystem::path& path) {
  const std::string text = json.dump(2) + "\n";
  path == "-" ? print(text) : atomic_write(path, text);
}

void check_targets(const std::filesystem::path& input, const std::filesystem::path& output,
                   const std::filesystem::path& json) {
  if (!output.empty()) check_writable(output);
  if (!json.empty()) check_writable(json);
  // One file can have many names: ./tin.ply, its absolute path, a link to it.
  std::error_code ignored;
  const auto resolved = [&](const std::filesystem::path& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, ignored), ignored);
  };
  const auto same = [&](const std::filesystem::path& a, const std::filesystem::path& b) {
    return !a.empty() && !b.empty() && a != "-" && resolved(a) == resolved(b);
  };
  if (same(output, json))
    throw ParameterError(fmt::format("{} is named for the output and for the JSON", json.string()));
  for (const std::filesystem::path& target : {output, json})
    if (same(input, target))
      throw ParameterError(
          fmt::format("{} is the input; name another file to write to", target.string()));
}

Json to_json(const SplitCount& count) {
  return {{"interior", count.interior}, {"boundary", count.boundary}};
}

Json to_json(double value) {
  constexpr double exact_limit = 9007199254740992;  // 2^53
  if (value == std::floor(value) && std::abs(value) <= exact_limit) {
    return static_cast<std::int64_t>(value);
  }
  return value;
}

std::string counted(std::size_t count, std::string_view thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

std::size_t count_distinct(const PointSet& points) {
  std::vector<Point> sorted = points.xy;
  std::sort(sorted.begin(), sorted.end(), lexicographically_less);
  return static_cast<std::size_t>(std::unique(sorted.begin(), sorted.end()) - sorted.begin());
}

TerminalProgress::TerminalProgress() {
  if (!isatty(STDERR_FILENO)) return;
  relay_ = std::make_unique<ProgressRelay>([this](std::string_view phase, double fraction) {
    const std::string share = fraction < 0 ? "" : fmt::format(" {:.0f} %", 100 * fraction);
    // Not fmt::print: that throws when the terminal has gone, and here nobody would catch it.
    std::fputs(fmt::format("\r\033[Khodt: {}{} ...", phase, share).c_str(), stderr);
    std::fflush(stderr);
    shown_ = true;
  });
}

TerminalProgress::~TerminalProgress() {
  relay_.reset();
  if (shown_) std::fputs("\r\033[K", stderr);
}

void TerminalProgress::report(std::string_view phase, double fraction) {
  if (relay_) relay_->report(phase, fraction);
}

}  // namespace hodt::app
