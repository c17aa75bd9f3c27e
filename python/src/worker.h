// Threads that compute and stay: what TBB and the allocator keep for a thread they keep once,
// however many calls there are.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>

namespace hodt::python {

/// A thread that does one piece of work after another. All but its work needs Python's lock.
class Worker {
 public:
  /// One that has nothing to do.
  static Worker& take();
  /// For the next who needs one. It has finished.
  void give_back();

  /// The work throws nothing.
  void start(std::function<void()> work);
  /// Waits until the work is done. Python's lock may be another's meanwhile.
  void finish();

  /// After a fork: they are the parent's.
  static void forget_all();

 private:
  Worker();
  ~Worker() = delete;  // as long as the process
  void run();

  std::mutex mutex_;
  std::condition_variable news_;
  std::function<void()> work_;  // none: it has nothing to do
};

}  // namespace hodt::python
