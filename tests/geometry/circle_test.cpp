// Circle gives the answers of in_circle, and so does its filter alone where it dares to.
#include "hodt/geometry/circle.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "exact_oracle.h"
#include "quads.h"
#include <gtest/gtest.h>

namespace hodt {
namespace {

using quads::Family;
using quads::Quad;
using quads::Random;

class CircleFamilies : public testing::TestWithParam<Family> {};

INSTANTIATE_TEST_SUITE_P(Families, CircleFamilies, testing::ValuesIn(quads::kFamilies),
                         [](const auto& family) { return std::string(family.param.name); });

// One circle of the family, many points: some of the family, some of quite another kind.
TEST_P(CircleFamilies, AgreesWithTheOracle) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    Quad q = GetParam().make(random);
    const int sign = exact_oracle::orient(q[0], q[1], q[2]);
    if (sign == 0) continue;
    if (sign < 0) std::swap(q[1], q[2]);
    const Circle circle(q[0], q[1], q[2]);
    std::vector<Point> questions = {q[3]};
    for (const Point& p : GetParam().make(random)) questions.push_back(p);
    for (const Point& p : quads::mixture(random)) questions.push_back(p);
    for (const Point& p : questions) {
      const bool is_corner = p == q[0] || p == q[1] || p == q[2];
      ASSERT_EQ(circle.side_plain(p), exact_oracle::in_circle_plain(q[0], q[1], q[2], p));
      ASSERT_EQ(circle.contains(p), !is_corner && exact_oracle::in_circle(q[0], q[1], q[2], p));
    }
  }
}

TEST(Circle, ItsCornersAreOnItAndNotInIt) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    Quad q = quads::nearly_collinear(random);
    if (orient(q[0], q[1], q[2]) < 0) std::swap(q[0], q[1]);
    if (orient(q[0], q[1], q[2]) == 0) continue;
    const Circle circle(q[0], q[1], q[2]);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(circle.side_plain(q[k]), 0);
      EXPECT_FALSE(circle.contains(q[k]));
    }
  }
}

TEST(Circle, UnitCircle) {
  const Circle circle({1, 0}, {0, 1}, {-1, 0});
  EXPECT_EQ(circle.side_plain({0, 0}), 1);
  EXPECT_EQ(circle.side_plain({0.6, 0.7}), 1);
  EXPECT_EQ(circle.side_plain({0, -1}), 0);
  EXPECT_EQ(circle.side_plain({0.8, 0.7}), -1);
  // Of (1,0) (0,1) (-1,0) (0,-1) the first is the largest: the diagonal is from (0,1) to (0,-1).
  EXPECT_TRUE(circle.contains({0, -1}));
  EXPECT_FALSE(Circle({1, 0}, {0, 1}, {0, -1}).contains({-1, 0}));
}

}  // namespace
}  // namespace hodt
