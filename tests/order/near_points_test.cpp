#include "hodt/order/search/near_points.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <vector>

#include "../support/convert.h"
#include "../support/shapes.h"
#include <gtest/gtest.h>

#include "hodt/geometry/predicates.h"

namespace hodt {
namespace {

using Set = PlaceSet<2>;

/// The points around the first of a set, which is at place 0.
class Around {
 public:
  explicit Around(std::vector<Point> points) : points_(std::move(points)) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < points_.size(); ++i)
      nearest = std::min(nearest, std::max(std::fabs(offset(i).x), std::fabs(offset(i).y)));
    near_.clear(nearest);
    run_in_lanes([&]<Index N>() HODT_INLINE_LAMBDA {
      // In two parts, as they come in practice.
      for (const std::size_t end : {points_.size() / 2 + 1, points_.size()}) {
        for (std::size_t i = near_.size(); i < end; ++i) near_.set(Index(i), offset(i));
        is_near_ &= near_.template add<N>(Index(end));
      }
    });
  }

  Point offset(std::size_t i) const {
    return {points_[i].x - points_[0].x, points_[i].y - points_[0].y};
  }
  const Point& point(Index i) const { return points_[i]; }
  Index size() const { return Index(points_.size()); }
  const NearPoints<2>& near() const { return near_; }
  bool is_near() const { return is_near_; }
  NearPoints<2>::Split split(const ImageHalfPlane& plane) const {
    return run_in_lanes([&]<Index N>()
                            HODT_INLINE_LAMBDA { return near_.template split<N>(plane); });
  }

 private:
  std::vector<Point> points_;
  NearPoints<2> near_;
  bool is_near_ = true;
};

/// What is said to be sure is so. How much is left open is returned.
struct Openness {
  std::size_t open = 0, all = 0;
};
Openness expect_true(const Around& around) {
  Openness openness;
  const Point& u = around.point(0);
  for (Index i = 1; i < around.size(); ++i) {
    const NearPoints<2>::Split sides = around.split(around.near().left_of(i));
    for (Index p = 0; p < around.size(); ++p) {
      const int side = orient(u, around.point(i), around.point(p));
      EXPECT_TRUE(!sides.in.has(p) || side > 0);
      EXPECT_TRUE(!sides.out.has(p) || side < 0);
    }
    EXPECT_EQ(around.near().larger().has(i), lexicographically_less(u, around.point(i)));
    for (Index j = 1; j < around.size(); ++j) {
      if (orient(u, around.point(i), around.point(j)) <= 0) continue;
      const NearPoints<2>::Split circle = around.split(around.near().inside(i, j));
      EXPECT_TRUE((circle.in - Set::first(around.size())).is_empty());
      for (Index p = 0; p < around.size(); ++p) {
        const int inside = in_circle_plain(u, around.point(i), around.point(j), around.point(p));
        EXPECT_TRUE(!circle.in.has(p) || inside > 0);
        EXPECT_TRUE(!circle.out.has(p) || inside < 0 || p == 0);
        if (p == 0 || p == i || p == j) continue;
        ++openness.all;
        openness.open += !circle.in.has(p) && !circle.out.has(p);
      }
    }
  }
  return openness;
}

class NearFamilies : public testing::TestWithParam<families::Family> {};

TEST_P(NearFamilies, what_is_sure_is_so) {
  for (const int n : {8, 17, 30, 64, 100}) {
    if (GetParam().name == "wide_range" && n > 17) continue;
    const std::vector<Point> points = support::to_point_set(GetParam().make(n, n)).xy;
    const Around around(points);
    if (around.is_near()) expect_true(around);
  }
}

INSTANTIATE_TEST_SUITE_P(All, NearFamilies, testing::ValuesIn(families::all()),
                         [](const auto& each) { return each.param.name; });

TEST(NearPoints, little_is_left_open) {
  for (const Index lanes : {4u, 8u, 16u}) {
    const LaneLimit limit(lanes);
    const Openness openness = expect_true(Around(support::uniform(100, 3)));
    EXPECT_GT(openness.all, 50000u);
    EXPECT_LT(double(openness.open), 1e-3 * double(openness.all));
  }
}

/// Seen from u in nearly the same direction, where single precision does not tell.
TEST(NearPoints, little_is_left_open_in_narrow_angles) {
  for (const double width : {1e-1, 1e-2, 1e-3}) {
    std::vector<Point> points = support::uniform(60, 4);
    for (Point& p : points) p = {1 + p.x, width * p.y};
    points.front() = {0, 0};
    const Openness openness = expect_true(Around(points));
    EXPECT_GT(openness.all, 50000u);
    EXPECT_LT(double(openness.open), 1e-2 * double(openness.all)) << width;
  }
}

TEST(PlaceSet, is_a_set) {
  using Places = PlaceSet<4>;
  std::set<Index> a, b;
  Places in_a, in_b;
  families::Random random(3);
  for (int i = 0; i < 90; ++i) {
    a.insert(Index(random.bits() % 256));
    b.insert(Index(random.bits() % 256));
  }
  for (const Index i : a) in_a |= Places::only(i);
  for (const Index i : b) in_b |= Places::only(i);
  const auto list = [](const Places& places) {
    std::vector<Index> members;
    places.for_each([&](Index i) { members.push_back(i); });
    return members;
  };
  std::vector<Index> both, either, rest;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(either));
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(rest));
  EXPECT_EQ(list(in_a & in_b), both);
  EXPECT_EQ(list(in_a | in_b), either);
  EXPECT_EQ(list(in_a - in_b), rest);
  EXPECT_EQ(in_a.count(), a.size());
  EXPECT_TRUE((in_a - in_a).is_empty());
  EXPECT_FALSE(in_a.is_empty());
  for (Index i = 0; i < 256; ++i) EXPECT_EQ(in_a.has(i), a.contains(i));
  for (const Index size : {0u, 1u, 63u, 64u, 65u, 128u, 200u, 255u, 256u}) {
    const std::vector<Index> first = list(Places::first(size));
    EXPECT_EQ(first.size(), size);
    EXPECT_TRUE(first.empty() || first.back() == size - 1);
  }
}

TEST(NearPoints, far_points_are_refused) {
  EXPECT_TRUE(Around({{0, 0}, {1, 0}, {0, 1e15}}).is_near());
  EXPECT_FALSE(Around({{0, 0}, {1, 0}, {0, 1e18}}).is_near());
  EXPECT_FALSE(Around({{0, 0}, {1e-300, 0}, {1e300, 1}}).is_near());
}

}  // namespace
}  // namespace hodt
