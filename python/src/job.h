// Long work for Python: without its lock, on a number of threads, and ended by Ctrl-C.
#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <optional>
#include <utility>

#include <nanobind/nanobind.h>

#include "hodt/base/parallel.h"
#include "hodt/base/progress.h"
#include "hodt/base/stop.h"

namespace hodt::python {

namespace nb = nanobind;

/// What every function that computes takes.
struct JobOptions {
  std::size_t threads = 0;           ///< 0: all cores
  nb::object progress = nb::none();  ///< called with a phase and a fraction, or None
  bool is_short = false;             ///< done before anybody could wish to end it
};

/// Runs `work`, which is handed a Progress to tell of, on another thread, while this one waits
/// and lets Python handle signals. An exception of a signal's handler (KeyboardInterrupt), or of
/// the progress function, stops the work and is thrown once it has stopped.
void run_job(const JobOptions& options, const std::function<void(const Progress&)>& work);

/// The same of work that returns something.
template <class Work>
auto result_of(const JobOptions& options, const Work& work) {
  std::optional<decltype(work(Progress()))> result;
  run_job(options, [&](const Progress& progress) { result.emplace(work(progress)); });
  return std::move(*result);
}

}  // namespace hodt::python
