#include "hodt/base/progress.h"

#include <utility>

namespace hodt {

ProgressRelay::ProgressRelay(Progress reader, Duration after, Duration interval)
    : reader_(std::move(reader)), thread_([this, after, interval] { run(after, interval); }) {}

ProgressRelay::~ProgressRelay() {
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
  }
  stop_signal_.notify_one();
  thread_.join();
}

void ProgressRelay::report(std::string_view phase, double fraction) {
  const std::lock_guard lock(mutex_);
  phase_ = phase;
  fraction_ = fraction;
}

void ProgressRelay::run(Duration after, Duration interval) {
  std::unique_lock lock(mutex_);
  Duration wait = after;
  while (!stop_signal_.wait_for(lock, wait, [this] { return stopped_; })) {
    const std::string phase = phase_;
    const double fraction = fraction_;
    // The job must not wait for the reader.
    lock.unlock();
    reader_(phase, fraction);
    lock.lock();
    wait = interval;
  }
}

}  // namespace hodt
