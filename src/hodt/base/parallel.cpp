#include "hodt/base/parallel.h"

#include <algorithm>

#include <tbb/global_control.h>
#include <tbb/info.h>

namespace hodt {

namespace {

std::size_t or_all_cores(std::size_t threads) {
  return threads ? threads
                 : static_cast<std::size_t>(std::max(1, tbb::info::default_concurrency()));
}

}  // namespace

struct ThreadLimit::Control {
  tbb::global_control limit;
};

ThreadLimit::ThreadLimit(std::size_t threads)
    : control_(new Control{{tbb::global_control::max_allowed_parallelism, or_all_cores(threads)}}) {
}

ThreadLimit::~ThreadLimit() = default;

std::size_t thread_count() {
  return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
}

}  // namespace hodt
