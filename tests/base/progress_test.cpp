#include "hodt/base/progress.h"

#include <atomic>
#include <chrono>
#include <future>
#include <string>
#include <thread>

#include <gtest/gtest.h>

namespace hodt {
namespace {

using Milliseconds = ProgressRelay::Duration;

TEST(ProgressRelay, short_jobs_are_not_shown) {
  std::atomic<int> calls = 0;
  {
    ProgressRelay relay([&](std::string_view, double) { ++calls; }, Milliseconds(60'000));
    relay.report("quick", 0.5);
  }
  EXPECT_EQ(calls, 0);
}

TEST(ProgressRelay, shows_the_latest_state) {
  std::promise<std::string> shown;
  std::atomic<bool> is_shown = false;
  ProgressRelay relay(
      [&](std::string_view phase, double fraction) {
        if (phase == "second" && fraction == 0.25 && !is_shown.exchange(true))
          shown.set_value(std::string(phase));
      },
      Milliseconds(1), Milliseconds(1));
  relay.report("first");
  relay.report("second", 0.25);
  EXPECT_EQ(shown.get_future().wait_for(std::chrono::seconds(30)), std::future_status::ready);
}

}  // namespace
}  // namespace hodt
