#include "hodt/base/round_marks.h"

#include <gtest/gtest.h>

namespace hodt {
namespace {

TEST(RoundMarks, are_set_once_in_a_round) {
  RoundMarks marks(3);
  for (int round = 0; round < 4; ++round) {
    marks.begin_round();
    for (const Index i : {Index{0}, Index{2}}) {
      EXPECT_NE(marks.marks()[i], marks.round());
      EXPECT_TRUE(marks.mark(i));
      EXPECT_FALSE(marks.mark(i));
      EXPECT_EQ(marks.marks()[i], marks.round());
    }
    EXPECT_NE(marks.marks()[1], marks.round());
  }
}

}  // namespace
}  // namespace hodt
