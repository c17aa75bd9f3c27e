// How others stop work that takes long: by a flag that the work goes by, on whatever thread it is.
#pragma once

#include <atomic>
#include <exception>
#include <utility>

namespace hodt {

/// What work ends with that was to stop. Of what it was making nothing is left.
class Stopped : public std::exception {
 public:
  const char* what() const noexcept override { return "stopped on request"; }
};

using StopFlag = std::atomic<bool>;

/// While it lives, work that this thread does or shares out (parallel.h) ends with Stopped, soon
/// after the flag is set by anybody; with nullptr, or where there is no such object, never. The
/// work looks at the flag before each piece that threads share, and where it looks at a Deadline.
class StopOn {
 public:
  explicit StopOn(const StopFlag* flag) : before_(std::exchange(mine, flag)) {}
  ~StopOn() { mine = before_; }
  StopOn(const StopOn&) = delete;
  StopOn& operator=(const StopOn&) = delete;

  /// What this thread goes by.
  static const StopFlag* flag() { return mine; }

 private:
  // Looked at in inner loops: initial-exec spares the call that a shared library would need.
  [[gnu::tls_model("initial-exec")]] static inline constinit thread_local const StopFlag* mine =
      nullptr;

  const StopFlag* before_;
};

inline bool is_to_stop() {
  const StopFlag* const flag = StopOn::flag();
  return flag != nullptr && flag->load(std::memory_order_relaxed);
}

/// Throws Stopped if the work is to stop.
inline void check_stop() {
  if (is_to_stop()) [[unlikely]]
    throw Stopped();
}

}  // namespace hodt
