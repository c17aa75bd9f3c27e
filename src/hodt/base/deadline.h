// A moment after which a search is to stop.
#pragma once

#include <chrono>

namespace hodt {

class Deadline {
 public:
  /// Never passes: a search is then limited by its work, and does the same on every machine.
  Deadline() = default;
  /// `seconds` from now; 0 is never.
  explicit Deadline(double seconds) {
    if (seconds <= 0 || seconds > kLongest) return;
    limited_ = true;
    at_ = Clock::now() +
          std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  }
  bool passed() const { return limited_ && Clock::now() >= at_; }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr double kLongest = 1e9;

  bool limited_ = false;
  Clock::time_point at_;
};

}  // namespace hodt
