#include "hodt/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace hodt {
namespace {

TEST(Parallel, every_element_is_visited_once) {
  for (const std::size_t threads : {1u, 2u, 5u})
    for (const std::size_t size : {0u, 1u, 7u, 64u, 10'000u}) {
      const ThreadLimit limit(threads);
      std::vector<std::atomic<int>> visits(size + 3);
      parallel_for(3, 3 + size, 64, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) ++visits[i];
      });
      for (std::size_t i = 0; i < visits.size(); ++i) EXPECT_EQ(visits[i], i >= 3) << i;
    }
}

/// Sums of doubles depend on the order: it has to be that of the pieces.
TEST(Parallel, results_are_the_same_on_any_number_of_threads) {
  std::vector<double> values(100'000);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = 1.0 / double(i + 1);
  const auto sum = [&](std::size_t first, std::size_t last) {
    return std::accumulate(values.data() + first, values.data() + last, 0.0);
  };
  const auto odd = [](std::size_t first, std::size_t last, std::vector<std::size_t>& found) {
    for (std::size_t i = first; i < last; ++i)
      if (i % 2) found.push_back(i);
  };
  const auto run = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    return std::pair(parallel_sum(0, values.size(), 100, sum),
                     parallel_collect<std::size_t>(5, 70'000, 64, odd));
  };
  const auto alone = run(1);
  EXPECT_EQ(alone.second.size(), 34'998u);
  EXPECT_TRUE(std::is_sorted(alone.second.begin(), alone.second.end()));
  for (const std::size_t threads : {2u, 3u, 8u}) EXPECT_EQ(run(threads), alone) << threads;
}

TEST(Parallel, streams_are_what_is_collected_at_once) {
  const auto squares = [](std::size_t first, std::size_t last, std::vector<std::size_t>& found) {
    for (std::size_t i = first; i < last; ++i) found.push_back(i * i);
  };
  std::vector<std::size_t> streamed;
  std::size_t batches = 0;
  parallel_stream<std::size_t>(0, 1001, 100, 7, squares, [&](std::vector<std::size_t>& batch) {
    streamed.insert(streamed.end(), batch.begin(), batch.end());
    ++batches;
  });
  EXPECT_EQ(streamed, parallel_collect<std::size_t>(0, 1001, 13, squares));
  EXPECT_EQ(batches, 11u);
}

TEST(Parallel, errors_come_through) {
  const auto fail = [](std::size_t first, std::size_t last) {
    if (first <= 500 && 500 < last) throw std::runtime_error("in a piece");
  };
  EXPECT_THROW(parallel_for(0, 1000, 10, fail), std::runtime_error);
}

TEST(Parallel, limits_hold_while_they_live) {
  const std::size_t before = thread_count();
  {
    const ThreadLimit limit(1);
    EXPECT_EQ(thread_count(), 1u);
  }
  EXPECT_EQ(thread_count(), before);
}

TEST(Parallel, both_of_two_run) {
  int a = 0, b = 0;
  parallel_invoke([&] { a = 1; }, [&] { b = 2; });
  EXPECT_EQ(a + b, 3);
}

}  // namespace
/// What failed beside it must not end a loop half done as if it were done.
TEST(Parallel, loops_are_complete_while_work_beside_them_fails) {
  constexpr std::size_t kCount = 2000;
  for (int round = 0; round < 100; ++round) {
    std::atomic<bool> has_begun = false, is_incomplete = false;
    const auto fail = [&] {
      for (int i = 0; i < 10'000 && !has_begun; ++i) std::this_thread::yield();
      throw std::runtime_error("failed");
    };
    const auto compute = [&] {
      std::vector<std::atomic<bool>> done(kCount);
      parallel_for(0, kCount, 1, [&](std::size_t first, std::size_t last) {
        has_begun = true;
        for (std::size_t i = first; i < last; ++i) done[i] = true;
        std::this_thread::yield();
      });
      is_incomplete =
          !std::all_of(done.begin(), done.end(), [](const auto& d) { return d.load(); });
    };
    EXPECT_THROW(parallel_invoke(compute, fail), std::runtime_error);
    ASSERT_FALSE(is_incomplete);
  }
}

}  // namespace hodt
