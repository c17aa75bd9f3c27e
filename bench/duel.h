// Timing two things in turn, so that a machine whose speed drifts favours neither.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace duel {

template <class F>
double seconds(const F& f) {
  const auto start = std::chrono::steady_clock::now();
  f();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

inline double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v[v.size() / 2];
}

/// The value of `--name V` among the arguments, or `fallback`.
inline std::size_t option(int argc, char** argv, std::string_view name, std::size_t fallback) {
  for (int i = 1; i + 1 < argc; ++i)
    if (argv[i] == name) return std::stoul(argv[i + 1]);
  return fallback;
}

/// A line of /proc/self/status in bytes, such as VmRSS (now) or VmHWM (the peak).
inline double status_bytes(std::string_view name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(name)) return std::stod(line.substr(name.size() + 1)) * 1024;
  return 0;
}

/// Peak memory in bytes that f adds to this process, measured in a child of its own.
template <class F>
double peak_bytes(const F& f) {
  int channel[2];
  if (pipe(channel) != 0) return 0;
  const pid_t child = fork();
  if (child == 0) {
    std::ofstream("/proc/self/clear_refs") << 5 << std::flush;  // the peak starts anew
    const double before = status_bytes("VmRSS");
    f();
    const double added = status_bytes("VmHWM") - before;
    const bool written = write(channel[1], &added, sizeof added) == sizeof added;
    _exit(written ? 0 : 1);
  }
  double added = 0;
  if (read(channel[0], &added, sizeof added) != sizeof added) added = 0;
  close(channel[0]);
  close(channel[1]);
  waitpid(child, nullptr, 0);
  return added;
}

}  // namespace duel
