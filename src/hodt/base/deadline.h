// A moment after which a search is to stop.
#pragma once

#include <algorithm>
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
  bool is_limited() const { return limited_; }
  /// 0 if passed. REQUIRES is_limited().
  double seconds_left() const {
    return std::max(0.0, std::chrono::duration<double>(at_ - Clock::now()).count());
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr double kLongest = 1e9;

  bool limited_ = false;
  Clock::time_point at_;
};

}  // namespace hodt
