#include "job.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace hodt::python {

namespace {

/// Lets other Python threads run while it lives.
class WithoutLock {
 public:
  WithoutLock() : state_(PyEval_SaveThread()) {}
  ~WithoutLock() { PyEval_RestoreThread(state_); }
  WithoutLock(const WithoutLock&) = delete;
  WithoutLock& operator=(const WithoutLock&) = delete;

 private:
  PyThreadState* state_;
};

class Job {
 public:
  explicit Job(const JobOptions& options) : options_(options) {}

  /// On this thread.
  void run_here(const std::function<void(const Progress&)>& work) {
    const WithoutLock without_lock;
    compute(work);
  }

  /// On another thread, while this one looks after Python.
  void run_aside(const std::function<void(const Progress&)>& work) {
    std::thread worker;
    {
      const WithoutLock without_lock;
      worker = std::thread([&] {
        compute(work);
        const std::lock_guard lock(mutex_);
        is_done_ = true;
        news_.notify_one();
      });
    }
    while (!wait()) look_after_python();
    {
      const WithoutLock without_lock;  // the worker is at its end, but not for sure
      worker.join();
    }
    if (!raised_) look_after_python();
  }

  void throw_what_happened() {
    if (raised_) std::rethrow_exception(raised_);
    if (failed_) std::rethrow_exception(failed_);
  }

 private:
  using Phase = std::pair<std::string, double>;
  static constexpr auto kPatience = std::chrono::milliseconds(50);

  void compute(const std::function<void(const Progress&)>& work) {
    try {
      const StopOn stop(&is_to_stop_);
      std::optional<ThreadLimit> limit;
      if (options_.threads > 0) limit.emplace(options_.threads);
      Progress progress;
      if (!options_.progress.is_none())
        progress = [this](std::string_view phase, double fraction) { note(phase, fraction); };
      work(progress);
    } catch (...) {
      failed_ = std::current_exception();
    }
  }

  void note(std::string_view phase, double fraction) {
    check_stop();
    const std::lock_guard lock(mutex_);
    phases_.emplace_back(phase, fraction);
    news_.notify_one();
  }

  /// Whether the work is done; if not, there is news, or some time has passed.
  bool wait() {
    const WithoutLock without_lock;
    std::unique_lock lock(mutex_);
    news_.wait_for(lock, kPatience, [&] { return is_done_ || !phases_.empty(); });
    return is_done_;
  }

  void look_after_python() {
    if (raised_) return;
    try {
      if (PyErr_CheckSignals() != 0) throw nb::python_error();
      std::vector<Phase> phases;
      {
        const std::lock_guard lock(mutex_);
        phases.swap(phases_);
      }
      for (const auto& [phase, fraction] : phases) {
        const nb::object done = fraction < 0 ? nb::none() : nb::cast(fraction);
        options_.progress(phase.c_str(), done);
      }
    } catch (...) {
      raised_ = std::current_exception();
      is_to_stop_ = true;
    }
  }

  const JobOptions& options_;
  StopFlag is_to_stop_ = false;
  std::exception_ptr raised_, failed_;  // by Python, and by the work
  std::mutex mutex_;
  std::condition_variable news_;
  bool is_done_ = false;
  std::vector<Phase> phases_;  // not told yet
};

}  // namespace

void run_job(const JobOptions& options, const std::function<void(const Progress&)>& work) {
  Job job(options);
  if (options.is_short && options.progress.is_none())
    job.run_here(work);
  else
    job.run_aside(work);
  job.throw_what_happened();
}

}  // namespace hodt::python
