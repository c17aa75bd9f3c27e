#include "hodt/base/csr_lists.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace hodt {
namespace {

TEST(CsrLists, are_sorted_and_without_repetitions) {
  const CsrLists lists(4, {{2, 5}, {0, 3}, {2, 1}, {2, 5}, {0, 3}, {3, 0}, {2, 4}});
  const std::vector<std::vector<Index>> expected{{3}, {}, {1, 4, 5}, {0}};
  ASSERT_EQ(lists.size(), expected.size());
  for (Index i = 0; i < lists.size(); ++i) EXPECT_TRUE(std::ranges::equal(lists[i], expected[i]));
}

TEST(CsrLists, of_nothing) {
  EXPECT_EQ(CsrLists().size(), 0u);
  const CsrLists empty(3, {});
  ASSERT_EQ(empty.size(), 3u);
  for (Index i = 0; i < 3; ++i) EXPECT_TRUE(empty[i].empty());
}

}  // namespace
}  // namespace hodt
