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

namespace {

bool is_whole(std::string_view text) {
  const auto is_digit = [](char c) { return '0' <= c && c <= '9'; };
  return !text.empty() && std::all_of(text.begin(), text.end(), is_digit);
}

/// What a path leads to: one file can have many names (./tin.ply, its absolute path, a link to it).
std::filesystem::path resolved(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::weakly_canonical(std::filesystem::absolute(follow_links(path), ignored),
                                           ignored);
}

/// Whether both are written to the same place. An empty path is none.
bool is_same_output(const std::filesystem::path& a, const std::filesystem::path& b) {
  if (a.empty() || b.empty()) return false;
  if (is_standard_output(a) || is_standard_output(b))
    return is_standard_output(a) && is_standard_output(b);
  return resolved(a) == resolved(b);
}

bool is_input(const std::filesystem::path& output, const std::filesystem::path& input) {
  std::error_code missing;
  return !is_standard_output(output) && std::filesystem::equivalent(output, input, missing);
}

}  // namespace

std::uint64_t parse_whole(std::string_view option, const std::string& text, std::uint64_t least,
                          std::uint64_t most) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (!is_whole(text) || error != std::errc() || value < least || value > most) {
    throw ParameterError(fmt::format("{} must be a whole number from {} to {}, not '{}'", option,
                                     least, most, text));
  }
  return value;
}

Order parse_order(const std::string& text, std::string_view option, Index least) {
  // More digits than these are no number to a reader of JSON.
  constexpr std::size_t most_digits = 300;
  const auto refuse = [&] {
    throw ParameterError(
        fmt::format("{} must be a whole number of at least {} and at most {} digits, not '{}'",
                    option, least, most_digits, text));
  };
  if (!is_whole(text) || text.size() > most_digits) refuse();
  const std::size_t zeros = std::min(text.find_first_not_of('0'), text.size() - 1);
  Order order{kNone - 1, text.substr(zeros)};
  Index value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc()) order.limit = std::min(value, order.limit);
  if (order.limit < least) refuse();
  return order;
}

Json to_json(const Order& order) {
  const std::string& digits = order.digits;
  std::uint64_t whole = 0;
  if (std::from_chars(digits.data(), digits.data() + digits.size(), whole).ec == std::errc())
    return whole;
  double value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

namespace {

/// A finite number; nothing if the text is anything else.
std::optional<double> finite_number(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  return is_number && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

[[noreturn]] void refuse_number(std::string_view option, std::string_view what,
                                const std::string& text) {
  throw ParameterError(fmt::format("{} must be {}, not '{}'", option, what, text));
}

}  // namespace

double parse_number(std::string_view option, const std::string& text) {
  const std::optional<double> value = finite_number(text);
  if (!value) refuse_number(option, "a number", text);
  return *value;
}

double parse_non_negative(std::string_view option, std::string_view what, const std::string& text) {
  if (text.empty()) return 0;
  const std::optional<double> value = finite_number(text);
  if (!value || *value < 0) refuse_number(option, what, text);
  return *value;
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

void print(std::string_view lines) {
  std::string text;
  for (std::size_t end; !lines.empty(); lines.remove_prefix(end)) {
    end = std::min(lines.find('\n'), lines.size() - 1) + 1;
    const bool is_whole_line = lines[end - 1] == '\n';
    text += printable(lines.substr(0, is_whole_line ? end - 1 : end));
    if (is_whole_line) text += '\n';
  }
  try {
    atomic_write("-", text);
  } catch (const BrokenPipeError&) {
    // `hodt ... | head` has seen enough.
  }
}

void check_other_outputs(std::string_view option, const std::string& file,
                         std::span<const std::string> others) {
  for (const std::string& other : others)
    if (is_same_output(file, other))
      throw ParameterError(
          fmt::format("{} names {}, which is another output as well", option, file));
}

void check_targets(const std::filesystem::path& input, const std::filesystem::path& output,
                   const std::filesystem::path& json) {
  if (!output.empty()) check_writable(output);
  if (!json.empty()) check_writable(json);
  if (is_same_output(output, json))
    throw ParameterError(fmt::format("{} is named for the output and for the JSON", json.string()));
  for (const std::filesystem::path& target : {output, json})
    if (is_input(target, input))
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

std::string counted(std::size_t count, std::string_view thing, std::string_view things) {
  if (count == 1) return fmt::format("1 {}", thing);
  return things.empty() ? fmt::format("{} {}s", count, thing) : fmt::format("{} {}", count, things);
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
