// What parallel.h needs, on std::thread alone: for the thread sanitizer, which does not see how
// oneTBB synchronises, as Debian's is built without it. Slower, but with the same pieces of work
// running at the same time, so that races show.
// Tested by tests/base/parallel_test.cpp.
#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <thread>

namespace hodt::plain_threads {

template <class F, class G>
void parallel_invoke(const F& f, const G& g) {
  std::exception_ptr failure;
  std::thread other([&] {
    try {
      f();
    } catch (...) {
      failure = std::current_exception();
    }
  });
  try {
    g();
  } catch (...) {
    other.join();
    throw;
  }
  other.join();
  if (failure) std::rethrow_exception(failure);
}

template <class F>
void parallel_for(std::size_t begin, std::size_t end, const F& f) {
  const std::size_t middle = begin + (end - begin) / 2;
  parallel_invoke([&] { f(begin, middle); }, [&] { f(middle, end); });
}

template <class T>
class PerThread {
 public:
  explicit PerThread(std::function<T()> make) : make_(std::move(make)) {}
  T& local() {
    const std::lock_guard lock(mutex_);
    std::unique_ptr<T>& value = values_[std::this_thread::get_id()];
    // In place, not by make_unique: a T need not be movable.
    if (!value) value = std::unique_ptr<T>(new T(make_()));
    return *value;
  }

 private:
  std::function<T()> make_;
  std::mutex mutex_;
  std::map<std::thread::id, std::unique_ptr<T>> values_;
};

}  // namespace hodt::plain_threads
