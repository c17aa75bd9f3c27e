#include "hodt/base/parallel.h"

#include <algorithm>

#include <tbb/info.h>

namespace hodt {

ThreadLimit::ThreadLimit(std::size_t threads)
    : control_(tbb::global_control::max_allowed_parallelism,
               threads ? threads : std::max(1, tbb::info::default_concurrency())) {}

std::size_t thread_count() {
  return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
}

}  // namespace hodt
