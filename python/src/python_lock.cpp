#include "python_lock.h"

#include <atomic>
#include <thread>

namespace hodt::python {

namespace {

std::atomic<int> at_work = 0;
std::atomic<bool> is_kept = false;
std::thread::id keeper;

bool is_kept_by_another() {
  return is_kept && std::this_thread::get_id() != keeper;
}

[[noreturn]] void stay() {
  nanobind::set_leak_warnings(false);  // what this thread holds stays as well
  --at_work;
  while (true) std::this_thread::sleep_for(std::chrono::hours(1));
}

}  // namespace

AtWork::AtWork() {
  ++at_work;
}

AtWork::~AtWork() {
  --at_work;
}

WithoutLock::~WithoutLock() {
  if (is_kept_by_another()) stay();
  PyEval_RestoreThread(state_);
}

void keep_lock_for_this_thread() {
  keeper = std::this_thread::get_id();
  is_kept = true;
}

void stay_if_lock_is_kept() {
  if (!is_kept_by_another()) return;
  PyEval_SaveThread();
  stay();
}

void wait_for_others(std::chrono::seconds patience) {
  const WithoutLock without_lock;
  const auto end = std::chrono::steady_clock::now() + patience;
  while (at_work > 0 && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

void forget_others() {
  at_work = 0;
}

}  // namespace hodt::python
