#include "worker.h"

#include <csignal>
#include <thread>
#include <utility>
#include <vector>

namespace hodt::python {

namespace {

std::vector<Worker*>& idle() {
  static std::vector<Worker*> workers;
  return workers;
}

/// Threads that begin while it lives leave signals to the others, which Python looks after.
class SignalsBlocked {
 public:
  SignalsBlocked() {
    sigset_t all;
    sigfillset(&all);
    for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP})
      sigdelset(&all, fault);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t before_;
};

}  // namespace

Worker::Worker() {
  const SignalsBlocked blocked;
  std::thread(&Worker::run, this).detach();
}

Worker& Worker::take() {
  if (idle().empty()) return *new Worker;
  Worker& worker = *idle().back();
  idle().pop_back();
  return worker;
}

void Worker::give_back() {
  idle().push_back(this);
}

void Worker::start(std::function<void()> work) {
  const std::lock_guard lock(mutex_);
  work_ = std::move(work);
  news_.notify_one();
}

void Worker::finish() {
  std::unique_lock lock(mutex_);
  news_.wait(lock, [&] { return !work_; });
}

void Worker::forget_all() {
  idle().clear();
}

void Worker::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    news_.wait(lock, [&] { return bool(work_); });
    lock.unlock();
    work_();
    lock.lock();
    work_ = nullptr;
    news_.notify_one();
  }
}

}  // namespace hodt::python
