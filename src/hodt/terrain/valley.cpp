#include "hodt/terrain/valley.h"

#include <algorithm>
#include <cmath>

#include "hodt/base/parallel.h"
#include "hodt/terrain/random.h"

namespace hodt {
namespace {

constexpr std::size_t kFewestCells = 64;
constexpr std::size_t kMostCells = 2048;
constexpr std::size_t kGrain = 1 << 14;

enum Purpose : std::uint64_t { kSurface, kPositions };

/// Rounds to the nearest thousandth, halves up. Division is exact to the last bit, so the result is
/// the double that reading "x.xxx" gives.
double to_millimetres(double metres) {
  return std::floor(metres * 1000 + 0.5) / 1000;
}

}  // namespace

std::uint32_t valley_side(std::size_t n) {
  return static_cast<std::uint32_t>(std::sqrt(static_cast<double>(n)) * 10'000);
}

TriangularGrid valley_grid(std::size_t n, std::uint64_t seed) {
  const double side = valley_side(n) / 1000.0;
  const auto cells = std::clamp(static_cast<std::size_t>(std::sqrt(static_cast<double>(n))),
                                kFewestCells, kMostCells);
  const double spacing = side / static_cast<double>(cells);
  const auto rows =
      static_cast<std::size_t>(static_cast<double>(cells) / TriangularGrid::kRowsPerSpacing);
  // One column and row more than the square needs at the far sides.
  return eroded_grid(cells + 3, rows + 3, spacing, derived_seed(seed, kSurface));
}

PointSet sample_valley(std::size_t n, std::uint64_t seed) {
  const TriangularGrid grid = valley_grid(n, seed);
  const std::uint32_t side = valley_side(n);
  const std::uint64_t positions = derived_seed(seed, kPositions);
  PointSet points;
  points.xy.resize(n);
  points.z.resize(n);
  parallel_for(0, n, kGrain, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const Point p{random_below(side + 1, positions, 2 * i) / 1000.0,
                    random_below(side + 1, positions, 2 * i + 1) / 1000.0};
      points.xy[i] = p;
      points.z[i] = to_millimetres(grid.height_at(p.x + grid.spacing / 2, p.y));
    }
  });
  return points;
}

}  // namespace hodt
