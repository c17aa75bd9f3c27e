#include "job.h"

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

#include "python_lock.h"
#include "sections.h"
#include "worker.h"
#include <pthread.h>

namespace hodt::python {

namespace {

int forks = 0;  // that this process came from

class Job {
 public:
  explicit Job(const JobOptions& options) : options_(options) { running().push_back(this); }
  ~Job() { std::erase(running(), this); }
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  /// Those that are not done. With Python's lock.
  static std::vector<Job*>& running() {
    static std::vector<Job*> jobs;
    return jobs;
  }
  void stop() { is_to_stop_ = true; }

  /// On this thread.
  void run_here(const std::function<void(const Progress&)>& work) {
    const WithoutLock without_lock;
    compute(work);
  }

  /// On another thread, while this one looks after Python.
  void run_aside(const std::function<void(const Progress&)>& work) {
    Worker& worker = Worker::take();
    worker.start([&, counted = std::make_shared<AtWork>()] {
      compute(work);
      const std::lock_guard lock(mutex_);
      is_done_ = true;
      news_.notify_one();
    });
    while (!wait()) look_after_python();
    {
      const WithoutLock without_lock;
      worker.finish();
    }
    worker.give_back();
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
    check_fork();
    const WithoutLock without_lock;
    std::unique_lock lock(mutex_);
    news_.wait_for(lock, kPatience, [&] { return is_done_ || !phases_.empty(); });
    return is_done_;
  }

  /// Progress functions and signal handlers may fork. The worker, and whatever it locked, is the
  /// parent's.
  void check_fork() {
    if (forks == forks_before_) return;
    throw_what_happened();
    throw std::runtime_error(
        "this process was forked while hodt computed, which goes on in the parent only");
  }

  void look_after_python() {
    if (raised_) return;
    try {
      if (PyErr_CheckSignals() != 0) throw nb::python_error();
      check_fork();
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
      stop();
    }
  }

  const JobOptions& options_;
  const int forks_before_ = forks;
  StopFlag is_to_stop_ = false;
  std::exception_ptr raised_, failed_;  // by Python, and by the work
  std::mutex mutex_;
  std::condition_variable news_;
  bool is_done_ = false;
  std::vector<Phase> phases_;  // not told yet
};

/// In a child.
void begin_anew() {
  ++forks;
  Job::running().clear();
  Worker::forget_all();
  forget_others();
}

/// Before Python ends: nothing computes afterwards.
void end_jobs() {
  keep_lock_for_this_thread();
  for (Job* const job : Job::running()) job->stop();
  wait_for_others(std::chrono::seconds(5));
}

}  // namespace

void run_job(const JobOptions& options, const std::function<void(const Progress&)>& work) {
  const AtWork counted;
  stay_if_lock_is_kept();
  Job job(options);
  if (options.is_short && options.progress.is_none())
    job.run_here(work);
  else
    job.run_aside(work);
  job.throw_what_happened();
}

void add_jobs(nb::module_&) {
  if (PyInterpreterState_GetID(PyInterpreterState_Get()) != 0) return;  // others begin and end
  pthread_atfork(nullptr, nullptr, begin_anew);
  nb::module_::import_("atexit").attr("register")(nb::cpp_function(end_jobs));
}

}  // namespace hodt::python
