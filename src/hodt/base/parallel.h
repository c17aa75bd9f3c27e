// The only header that knows how work is spread over cores.
//
// Every use gives the same bytes on any number of threads: a range is cut into pieces whose results
// do not depend on where it was cut, or land in a place fixed beforehand.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include "hodt/base/stop.h"

#if defined(__SANITIZE_THREAD__)
#define HODT_PLAIN_THREADS 1
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define HODT_PLAIN_THREADS 1
#endif
#endif

#ifdef HODT_PLAIN_THREADS
#include "hodt/base/plain_threads.h"
#else
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#endif

namespace hodt {

/// Runs f(first, last) on pieces of [begin, end) of about `grain` elements or more, in parallel.
/// Throws Stopped if the work is to stop (see stop.h).
template <class F>
void parallel_for(std::size_t begin, std::size_t end, std::size_t grain, const F& f) {
  if (end <= begin) return;
  check_stop();
  if (end - begin <= grain) {
    f(begin, end);
    return;
  }
  const auto piece = [&f, flag = StopOn::flag()](std::size_t first, std::size_t last) {
    const StopOn stop(flag);
    check_stop();
    f(first, last);
  };
#ifdef HODT_PLAIN_THREADS
  plain_threads::parallel_for(begin, end, piece);
#else
  // If work beside the loop fails, the loop goes on: to be cut short without an exception would
  // look as if it were done.
  tbb::task_group_context own(tbb::task_group_context::isolated);
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(begin, end, grain),
      [&](const tbb::blocked_range<std::size_t>& r) { piece(r.begin(), r.end()); }, own);
#endif
}

/// Collects what is found in parallel, time after time in the same memory: fresh memory from the
/// system takes longer than many a search.
template <class T>
class Collector {
 public:
  /// What f(first, last, found) adds to the vector `found` on each piece of [begin, end) of `grain`
  /// elements, in the order of the pieces.
  template <class F>
  std::vector<T>& collect(std::size_t begin, std::size_t end, std::size_t grain, const F& f) {
    const std::size_t pieces = begin < end ? (end - begin + grain - 1) / grain : 0;
    if (found_.size() < pieces) found_.resize(pieces);
    parallel_for(0, pieces, 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        found_[i].clear();
        f(begin + i * grain, std::min(end, begin + (i + 1) * grain), found_[i]);
      }
    });
    std::size_t total = 0;
    for (std::size_t i = 0; i < pieces; ++i) total += found_[i].size();
    all_.clear();
    all_.reserve(total);
    for (std::size_t i = 0; i < pieces; ++i)
      all_.insert(all_.end(), std::make_move_iterator(found_[i].begin()),
                  std::make_move_iterator(found_[i].end()));
    return all_;
  }

 private:
  std::vector<std::vector<T>> found_;  // of each piece
  std::vector<T> all_;
};

/// What a Collector finds, once.
template <class T, class F>
std::vector<T> parallel_collect(std::size_t begin, std::size_t end, std::size_t grain, const F& f) {
  return std::move(Collector<T>().collect(begin, end, grain, f));
}

/// The sum of what f(first, last) returns for each piece of [begin, end) of `grain` elements, added
/// up in the order of the pieces.
template <class F>
double parallel_sum(std::size_t begin, std::size_t end, std::size_t grain, const F& f) {
  const auto add_up = [&](std::size_t first, std::size_t last, std::vector<double>& found) {
    found.push_back(f(first, last));
  };
  double sum = 0;
  for (const double part : parallel_collect<double>(begin, end, grain, add_up)) sum += part;
  return sum;
}

/// What parallel_collect finds passed to `sink` in pieces of the result, each of `batch` elements
/// of [begin, end): only one is in memory at a time.
template <class T, class F, class Sink>
void parallel_stream(std::size_t begin, std::size_t end, std::size_t batch, std::size_t grain,
                     const F& f, const Sink& sink) {
  Collector<T> collector;
  for (; begin < end; begin += batch)
    sink(collector.collect(begin, std::min(end, begin + batch), grain, f));
}

/// Runs f() and g(), possibly at the same time. Throws Stopped as parallel_for does.
template <class F, class G>
void parallel_invoke(const F& f, const G& g) {
  const auto stoppable = [flag = StopOn::flag()](const auto& work) {
    return [flag, &work] {
      const StopOn stop(flag);
      check_stop();
      work();
    };
  };
#ifdef HODT_PLAIN_THREADS
  plain_threads::parallel_invoke(stoppable(f), stoppable(g));
#else
  tbb::task_group_context own(tbb::task_group_context::isolated);  // as for loops
  tbb::parallel_invoke(stoppable(f), stoppable(g), own);
#endif
}

/// Runs f so that a thread which waits for parallel work in it takes up no work from outside, which
/// could ask for what f holds.
template <class F>
void isolated(const F& f) {
#ifdef HODT_PLAIN_THREADS
  f();
#else
  tbb::this_task_arena::isolate(f);
#endif
}

/// One T for every thread that asks, made by `make` on the first call. For scratch memory only:
/// results must not depend on which thread did what.
template <class T>
class PerThread {
 public:
  template <class Make>
  explicit PerThread(const Make& make) : values_(make) {}
  T& mine() { return values_.local(); }

 private:
#ifdef HODT_PLAIN_THREADS
  plain_threads::PerThread<T> values_;
#else
  tbb::enumerable_thread_specific<T> values_;
#endif
};

/// While it lives, at most `threads` threads compute (0: as many as the machine has cores).
class ThreadLimit {
 public:
  explicit ThreadLimit(std::size_t threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

/// How many threads may compute now.
std::size_t thread_count();

}  // namespace hodt
