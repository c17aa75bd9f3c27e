// A moment after which a search is to stop.
// Tested by tests/optimize/time_limit_test.cpp.
#pragma once

#include <algorithm>
#include <chrono>
#include <exception>

#include "hodt/base/stop.h"

namespace hodt {

/// What a search ends with whose result is of no use unless it is complete. Whoever set the
/// deadline catches it, and says what is known without that search.
class TimeIsUp : public std::exception {
 public:
  const char* what() const noexcept override { return "the deadline has passed"; }
};

class Deadline {
 public:
  /// Never passes: a search is then limited by its work, and does the same on every machine.
  Deadline() = default;
  /// `seconds` from now; 0 is never.
  explicit Deadline(double seconds) {
    if (seconds <= 0 || seconds > kLongest) return;
    limited_ = true;
    at_ = Clock::now() + as_duration(seconds);
  }
  /// Throws Stopped if the work is to stop (see stop.h).
  bool passed() const {
    check_stop();
    return limited_ && Clock::now() >= at_;
  }
  /// Throws TimeIsUp if passed, and Stopped likewise.
  void check() const {
    if (passed()) throw TimeIsUp();
  }
  bool is_limited() const { return limited_; }
  /// So many seconds later.
  Deadline later(double seconds) const {
    Deadline deadline = *this;
    if (limited_) deadline.at_ += as_duration(seconds);
    return deadline;
  }
  /// 0 if passed. REQUIRES is_limited().
  double seconds_left() const {
    return std::max(0.0, std::chrono::duration<double>(at_ - Clock::now()).count());
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr double kLongest = 1e9;
  static Clock::duration as_duration(double seconds) {
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  }

  bool limited_ = false;
  Clock::time_point at_;
};

}  // namespace hodt
