#include "hodt/base/stop.h"

#include <atomic>
#include <cstddef>
#include <thread>

#include <gtest/gtest.h>

#include "hodt/base/deadline.h"
#include "hodt/base/parallel.h"

namespace hodt {
namespace {

TEST(Stop, work_without_a_flag_goes_on) {
  EXPECT_EQ(StopOn::flag(), nullptr);
  EXPECT_NO_THROW(check_stop());
  const StopFlag flag = false;
  const StopOn stop(&flag);
  EXPECT_NO_THROW(check_stop());
  EXPECT_FALSE(Deadline().passed());
}

TEST(Stop, a_flag_counts_while_its_object_lives) {
  const StopFlag outer = true, inner = false;
  {
    const StopOn stop(&outer);
    EXPECT_THROW(check_stop(), Stopped);
    EXPECT_THROW((void)Deadline().passed(), Stopped);
    EXPECT_THROW(Deadline(1e6).check(), Stopped);
    {
      const StopOn other(&inner);
      EXPECT_NO_THROW(check_stop());
    }
    EXPECT_TRUE(is_to_stop());
  }
  EXPECT_NO_THROW(check_stop());
}

TEST(Stop, work_that_threads_share_ends_after_the_pieces_at_hand) {
  for (const std::size_t threads : {1u, 2u, 4u}) {
    const ThreadLimit limit(threads);
    StopFlag flag = false;
    const StopOn stop(&flag);
    std::atomic<std::size_t> begun_too_late = 0;
    const auto visit = [&](std::size_t, std::size_t) {
      if (flag.exchange(true)) ++begun_too_late;
    };
    EXPECT_THROW(parallel_for(0, 1'000'000, 1, visit), Stopped);
    EXPECT_LT(begun_too_late, threads) << "each other thread may just have looked at the flag";
    EXPECT_THROW(parallel_for(0, 3, 10, visit), Stopped);
    EXPECT_THROW(parallel_invoke([] {}, [] {}), Stopped);
  }
}

/// Whichever thread does a piece goes by the flag of who shared it out, and by none afterwards.
TEST(Stop, the_flag_follows_the_work) {
  const StopFlag flag = false;
  std::atomic<std::size_t> strange = 0;
  const auto look = [&](std::size_t, std::size_t) {
    if (StopOn::flag() != &flag) ++strange;
    parallel_invoke([&] { strange += StopOn::flag() != &flag; },
                    [&] { strange += StopOn::flag() != &flag; });
  };
  {
    const StopOn stop(&flag);
    parallel_for(0, 10'000, 10, look);
  }
  EXPECT_EQ(strange, 0u);
  parallel_for(0, 10'000, 10, [&](std::size_t, std::size_t) {
    if (StopOn::flag() != nullptr) ++strange;
  });
  EXPECT_EQ(strange, 0u);
}

TEST(Stop, other_work_goes_on) {
  const StopFlag set = true;
  const StopOn stop(&set);
  std::atomic<std::size_t> visited = 0;
  std::thread([&] {
    parallel_for(0, 1000, 10,
                 [&](std::size_t first, std::size_t last) { visited += last - first; });
  }).join();
  EXPECT_EQ(visited, 1000u);
}

}  // namespace
}  // namespace hodt
