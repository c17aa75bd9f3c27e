// Progress of long jobs. The library only tells; whoever runs the job decides what to show.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace hodt {

/// Told what a job is doing and how much of that is done: 0 to 1, or negative if nobody knows.
using Progress = std::function<void(std::string_view phase, double fraction)>;

/// Passes progress on to a slow reader (a terminal): nothing for jobs shorter than `after`, then
/// the latest state every `interval`. The reader is called from another thread, never concurrently,
/// and never again once the relay is gone.
class ProgressRelay {
 public:
  using Duration = std::chrono::milliseconds;

  explicit ProgressRelay(Progress reader, Duration after = Duration(1000),
                         Duration interval = Duration(200));
  ~ProgressRelay();
  ProgressRelay(const ProgressRelay&) = delete;
  ProgressRelay& operator=(const ProgressRelay&) = delete;

  void report(std::string_view phase, double fraction = -1);

 private:
  void run(Duration after, Duration interval);

  Progress reader_;
  std::mutex mutex_;
  std::condition_variable stop_signal_;
  bool stopped_ = false;
  std::string phase_;
  double fraction_ = -1;
  std::thread thread_;
};

}  // namespace hodt
