#include "hodt/order/search/sector_levels.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "../support/shapes.h"
#include <gtest/gtest.h>

#include "hodt/base/lanes.h"

namespace hodt {
namespace {

struct Images {
  std::vector<float> x, y;
};

/// The fewest points beyond a line through point i with the origin on the other side, by all
/// directions in which that number can change. Not below the truth, as it leaves out what rounding
/// may hide.
Index fewest_beyond(const Images& images, Index n, Index i) {
  const double px = images.x[i], py = images.y[i], at = std::atan2(py, px);
  constexpr double kPi = 3.14159265358979323846;
  std::vector<double> angles;
  for (Index j = 0; j < n; ++j) {
    const double turn = std::atan2(images.y[j] - py, images.x[j] - px) + kPi / 2;
    for (const double angle : {turn, turn + kPi}) {
      for (const double nearby : {-1e-9, 1e-9}) {
        const double off = std::remainder(angle + nearby - at, 2 * kPi);
        if (std::fabs(off) < kPi / 2 - 1e-6) angles.push_back(at + off);
      }
    }
  }
  angles.push_back(at);
  Index fewest = n;
  for (const double angle : angles) {
    const double nx = std::cos(angle), ny = std::sin(angle), distance = px * nx + py * ny;
    Index beyond = 0;
    for (Index j = 0; j < n; ++j)
      beyond += j != i && images.x[j] * nx + images.y[j] * ny > distance * (1 + 1e-12);
    fewest = std::min(fewest, beyond);
  }
  return fewest;
}

/// Images of uniform points, or of points near a line through the origin's neighbourhood.
Images make_images(Index n, bool flat, families::Random& random) {
  const auto number = [&] { return double(random.bits() % 20001) / 10000 - 1; };
  Images images;
  images.x.resize(2 * n + 16);
  images.y.resize(2 * n + 16);
  for (Index i = 0; i < n; ++i) {
    const double x = number(), y = flat ? 0.5 + 0.01 * number() : number();
    const double r = x * x + y * y + 1e-6;
    images.x[i] = static_cast<float>(flat ? x : x / r);
    images.y[i] = static_cast<float>(flat ? y : y / r);
  }
  return images;
}

TEST(SectorLevels, proofs_hold_and_rule_out_most) {
  for (const Index lanes : {4u, 8u, 16u}) {
    const LaneLimit limit(lanes);
    families::Random random(3);
    for (const bool flat : {false, true}) {
      std::size_t deep = 0, proven = 0;
      for (const Index n : {1u, 2u, 7u, 40u, 150u}) {
        const Images images = make_images(n, flat, random);
        for (const Index k : {0u, 1u, 4u, 9u}) {
          SectorLevels levels;
          levels.clear(k);
          // In pieces, as they are gathered; one of an odd size.
          const Index middle = n / 3;
          levels.add(images.x.data(), images.y.data(), 0, middle);
          levels.add(images.x.data(), images.y.data(), middle, n);
          std::vector<Index> counts(n + 16, kNone);
          levels.bound(images.x.data(), images.y.data(), 0, n, counts.data());
          for (Index i = 0; i < n; ++i) {
            const Index fewest = fewest_beyond(images, n, i);
            ASSERT_LE(counts[i], fewest) << i << " of " << n << " k " << k;
            deep += fewest >= 2 * k + 4;
            proven += fewest >= 2 * k + 4 && counts[i] > k;
          }
        }
      }
      EXPECT_GT(deep, 100u);
      if (!flat) {
        EXPECT_GT(proven, deep * 9 / 10);
      }
    }
  }
}

}  // namespace
}  // namespace hodt
