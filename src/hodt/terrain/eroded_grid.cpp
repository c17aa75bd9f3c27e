// Stream power erosion after Braun and Willett (A very efficient O(n), implicit and parallel method
// to solve the stream power equation, Geomorphology 180, 2013).
//
// Water leaves each vertex along the steepest edge, to its receiver. Rivers cut in proportion to
// slope and to the square root of the area that they drain; with receivers before donors, the
// implicit equation is solved vertex by vertex, for steps as long as one likes. Where the published
// scheme has lakes, here there are none: the first receivers come from flooding the terrain from
// its border, and from then on each vertex is set above its receiver, so that steepest descent
// finds a lower neighbour everywhere.
#include "hodt/terrain/eroded_grid.h"

#include <algorithm>
#include <cmath>

#include "hodt/base/parallel.h"
#include "hodt/terrain/noise.h"
#include "hodt/terrain/random.h"

namespace hodt {
namespace {

constexpr double kHillDistance = 2500;  // m between the hills of the first surface
constexpr double kMeanHeight = 300;     // m, where the tilt begins
constexpr double kHillHeight = 200;     // m
constexpr double kTilt = 0.03;          // of the first surface, up to the north
constexpr double kRoughSlope = 0.2;     // of the bumps that make streams wander

constexpr double kHillslope = 0.8;       // slope of ground that drains next to nothing
constexpr double kChannelArea = 600;     // m2 drained where slopes begin to flatten
constexpr double kUplift = 240;          // m a step
constexpr double kLevelsPerMetre = 100;  // of the flood
constexpr std::uint32_t kWinding = 8;    // levels that the flood rises a vertex, at most

constexpr std::size_t kCoarsest = 64;  // vertices a side of the grid where rivers begin
constexpr int kFirstSteps = 30;        // of erosion, there
constexpr int kFurtherSteps = 4;       // on each finer grid
constexpr double kBend = 2;            // how far refining shifts a valley, in coarse spacings
constexpr double kBendLength = 6;      // distance between bends, in coarse spacings
constexpr std::size_t kMargin = 4;     // coarse vertices beyond the fine grid; more than kBend

constexpr std::size_t kGrain = 1 << 14;
/// More than any number of donors.
constexpr std::uint8_t kDone = 255;

enum Purpose : std::uint64_t { kHills, kRoughness, kRock, kFlood, kBendEast, kBendNorth };

/// Calls f(row) for the rows of [first, last), on all cores.
template <class F>
void for_each_row(const TriangularGrid& grid, std::size_t first, std::size_t last, const F& f) {
  const std::size_t rows_a_piece = std::max<std::size_t>(1, kGrain / grid.columns);
  parallel_for(first, last, rows_a_piece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) f(row);
  });
}

/// Calls f(vertex, x, y) for all vertices, on all cores.
template <class F>
void for_each_position(const TriangularGrid& grid, const F& f) {
  for_each_row(grid, 0, grid.rows, [&](std::size_t row) {
    const double y = static_cast<double>(row) * grid.row_spacing();
    const double shift = row % 2 ? 0.5 : 0.0;
    for (std::size_t column = 0; column < grid.columns; ++column) {
      f(row * grid.columns + column, (static_cast<double>(column) + shift) * grid.spacing, y);
    }
  });
}

/// Where the erosion starts: gentle hills, rough in the small so that streams wander.
void raise_hills(TriangularGrid& grid, std::uint64_t seed) {
  const std::uint64_t hills = derived_seed(seed, kHills);
  const std::uint64_t roughness = derived_seed(seed, kRoughness);
  for_each_position(grid, [&](std::size_t vertex, double x, double y) {
    grid.height[vertex] =
        kMeanHeight + kTilt * y +
        kHillHeight * fractal_noise(x / kHillDistance, y / kHillDistance, 7, hills) +
        kRoughSlope * grid.spacing * random_unit(roughness, vertex);
  });
}

/// How steep the rock stands, 1 on average: hard ridges, soft basins.
std::vector<float> rock_strength(const TriangularGrid& grid, std::uint64_t seed) {
  std::vector<float> strength(grid.size());
  const std::uint64_t rock = derived_seed(seed, kRock);
  for_each_position(grid, [&](std::size_t vertex, double x, double y) {
    strength[vertex] = static_cast<float>(
        1 + 0.9 * fractal_noise(x / kHillDistance * 1.5, y / kHillDistance * 1.5, 4, rock));
  });
  return strength;
}

/// Vertices waiting at levels 0, 1, ...: a stack a level, threaded through one array.
class LevelQueue {
 public:
  explicit LevelQueue(std::size_t vertices) : below_(vertices) {}

  void push(std::size_t level, Index vertex) {
    if (level >= top_.size()) top_.resize(2 * level + 1, kNone);
    below_[vertex] = top_[level];
    top_[level] = vertex;
  }
  /// The next vertex at the lowest level, kNone at the end. Levels pushed to never go down.
  Index pop() {
    while (level_ < top_.size() && top_[level_] == kNone) ++level_;
    if (level_ == top_.size()) return kNone;
    const Index vertex = top_[level_];
    top_[level_] = below_[vertex];
    return vertex;
  }
  std::size_t level() const { return level_; }

 private:
  std::vector<Index> top_;
  std::vector<Index> below_;
  std::size_t level_ = 0;
};

/// Water rises from the border; each vertex drains to where the water came from, a border vertex to
/// itself. A lake would fill at one level, and water cross it in straight lines; so the water rises
/// by a random bit at each step, and finds winding ways.
std::vector<Index> flood_from_border(const TriangularGrid& grid, std::uint64_t seed) {
  const double base = *std::min_element(grid.height.begin(), grid.height.end());
  std::vector<Index> receivers(grid.size(), kNone);
  LevelQueue queue(grid.size());
  const auto reach = [&](Index vertex, Index receiver) {
    receivers[vertex] = receiver;
    const auto own = static_cast<std::size_t>((grid.height[vertex] - base) * kLevelsPerMetre);
    queue.push(std::max(own, queue.level() + random_below(kWinding, seed, vertex)), vertex);
  };
  for (std::size_t vertex = 0; vertex < grid.size(); ++vertex) {
    if (grid.on_border(vertex)) reach(static_cast<Index>(vertex), static_cast<Index>(vertex));
  }
  for (Index vertex = queue.pop(); vertex != kNone; vertex = queue.pop()) {
    for (const Index next : neighbours_of(grid, vertex)) {
      if (receivers[next] == kNone) reach(next, vertex);
    }
  }
  return receivers;
}

/// Every vertex off the border drains to its lowest neighbour; of equal ones, to the first.
void drain_to_lowest(const TriangularGrid& grid, std::vector<Index>& receivers) {
  const auto columns = static_cast<std::ptrdiff_t>(grid.columns);
  for_each_row(grid, 1, grid.rows - 1, [&](std::size_t row) {
    const std::ptrdiff_t shift = row % 2 ? 1 : 0;
    const std::ptrdiff_t steps[5] = {columns + shift, columns + shift - 1, -1, -columns + shift - 1,
                                     -columns + shift};
    const std::size_t last = (row + 1) * grid.columns - 1;
    for (std::size_t vertex = row * grid.columns + 1; vertex < last; ++vertex) {
      const double* here = grid.height.data() + vertex;
      std::ptrdiff_t lowest = 1;
      for (const std::ptrdiff_t step : steps) {
        if (here[step] < here[lowest]) lowest = step;
      }
      receivers[vertex] = static_cast<Index>(static_cast<std::ptrdiff_t>(vertex) + lowest);
    }
  });
}

struct Rivers {
  std::vector<Index> area;   ///< how many vertices drain through each vertex, itself included
  std::vector<Index> order;  ///< all vertices, receivers first
};

/// Follows the water from each source downstream, for as long as no other tributary is missing.
Rivers gather(const std::vector<Index>& receivers) {
  const std::size_t size = receivers.size();
  std::vector<std::uint8_t> missing(size, 0);
  for (std::size_t vertex = 0; vertex < size; ++vertex) {
    if (receivers[vertex] != vertex) ++missing[receivers[vertex]];
  }
  Rivers rivers{std::vector<Index>(size, 1), std::vector<Index>(size)};
  std::size_t end = size;
  for (std::size_t source = 0; source < size; ++source) {
    if (missing[source] != 0) continue;
    auto vertex = static_cast<Index>(source);
    while (true) {
      missing[vertex] = kDone;
      rivers.order[--end] = vertex;
      const Index next = receivers[vertex];
      if (next == vertex) break;
      rivers.area[next] += rivers.area[vertex];
      if (--missing[next] != 0) break;
      vertex = next;
    }
  }
  return rivers;
}

/// One implicit step of uplift and erosion. Ends with every vertex above its receiver.
void erode_once(TriangularGrid& grid, const std::vector<Index>& receivers,
                const std::vector<float>& strength) {
  const Rivers rivers = gather(receivers);
  const double least_drop = minimum_drop(grid.spacing);
  const double area_ratio = grid.spacing * grid.row_spacing() / kChannelArea;
  for (const Index vertex : rivers.order) {
    if (receivers[vertex] == vertex) continue;
    // In balance with the uplift, a slope is kHillslope / sqrt(1 + area / kChannelArea).
    const double flow = std::sqrt(1 + rivers.area[vertex] * area_ratio);
    const double steady_drop = kHillslope * strength[vertex] * grid.spacing / flow;
    const double cut = kUplift / steady_drop;
    const double below = grid.height[receivers[vertex]];
    const double eroded = (grid.height[vertex] + kUplift + cut * below) / (1 + cut);
    grid.height[vertex] = std::max(eroded, below + least_drop);
  }
}

/// Lets the rivers cut, and find their ways anew, `steps` times.
void erode(TriangularGrid& grid, int steps, std::uint64_t seed) {
  const std::vector<float> strength = rock_strength(grid, seed);
  std::vector<Index> receivers = flood_from_border(grid, derived_seed(seed, kFlood));
  erode_once(grid, receivers, strength);
  for (int step = 1; step < steps; ++step) {
    drain_to_lowest(grid, receivers);
    erode_once(grid, receivers, strength);
  }
}

/// The same surface at half the spacing, with its valleys bent: a river on the coarse lattice runs
/// straight along its six directions.
TriangularGrid refined(const TriangularGrid& coarse, std::size_t columns, std::size_t rows,
                       std::uint64_t seed) {
  TriangularGrid grid{columns, rows, coarse.spacing / 2, std::vector<double>(columns * rows)};
  // Each level bends in its own way; the seeds must differ.
  const std::uint64_t level = derived_seed(seed, columns);
  const std::uint64_t east = derived_seed(level, kBendEast);
  const std::uint64_t north = derived_seed(level, kBendNorth);
  const std::uint64_t roughness = derived_seed(seed, kRoughness);
  const double wave = kBendLength * coarse.spacing;
  const double bend = kBend * coarse.spacing;
  const double margin = kMargin * coarse.spacing;
  for_each_position(grid, [&](std::size_t vertex, double x, double y) {
    const double u = x / wave;
    const double v = y / wave;
    grid.height[vertex] = coarse.height_at(x + margin + bend * fractal_noise(u, v, 3, east),
                                           y + margin + bend * fractal_noise(u, v, 3, north)) +
                          kRoughSlope * grid.spacing * random_unit(roughness, vertex);
  });
  return grid;
}

}  // namespace

bool TriangularGrid::on_border(std::size_t vertex) const {
  const std::size_t column = vertex % columns;
  const std::size_t row = vertex / columns;
  return column == 0 || column + 1 == columns || row == 0 || row + 1 == rows;
}

// In a band between two rows the lattice is a row of parallelograms, cut along their short
// diagonal:
//
//      upper ---- upper + 1        u runs along the row, v up the slanted side;
//      /  \        /               left of the diagonal u + v < 1.
//     /     \     /
//  lower ---- lower + 1
double TriangularGrid::height_at(double x, double y) const {
  const double band = y / row_spacing();
  const auto row = static_cast<std::size_t>(band);
  const double v = band - static_cast<double>(row);
  const bool shifted = row % 2 != 0;
  const double along = x / spacing - 0.5 * v - (shifted ? 0.5 : 0.0);
  // West of the first slanted side of a shifted row there is still the half of a parallelogram.
  const auto column = static_cast<std::ptrdiff_t>(along + 1) - 1;
  const double u = along - static_cast<double>(column);
  const double* lower = height.data() + row * columns + column;
  const double* upper = height.data() + (row + 1) * columns + column + (shifted ? 1 : 0);
  if (u + v <= 1) return lower[0] + u * (lower[1] - lower[0]) + v * (upper[0] - lower[0]);
  return upper[1] + (1 - u) * (upper[0] - upper[1]) + (1 - v) * (lower[1] - upper[1]);
}

Neighbours neighbours_of(const TriangularGrid& grid, std::size_t vertex) {
  const auto column = static_cast<std::ptrdiff_t>(vertex % grid.columns);
  const auto row = static_cast<std::ptrdiff_t>(vertex / grid.columns);
  const std::ptrdiff_t shift = row % 2;
  const std::ptrdiff_t steps[6][2] = {{1, 0},  {shift, 1},      {shift - 1, 1},
                                      {-1, 0}, {shift - 1, -1}, {shift, -1}};
  Neighbours neighbours;
  for (const auto& [right, up] : steps) {
    const std::ptrdiff_t c = column + right;
    const std::ptrdiff_t r = row + up;
    if (c < 0 || r < 0 || c >= static_cast<std::ptrdiff_t>(grid.columns) ||
        r >= static_cast<std::ptrdiff_t>(grid.rows)) {
      continue;
    }
    neighbours.vertex[neighbours.count++] =
        static_cast<Index>(r * static_cast<std::ptrdiff_t>(grid.columns) + c);
  }
  return neighbours;
}

double minimum_drop(double spacing) {
  return std::max(0.0005 * spacing, 0.002);
}

TriangularGrid eroded_grid(std::size_t columns, std::size_t rows, double spacing,
                           std::uint64_t seed) {
  if (std::min(columns, rows) <= kCoarsest) {
    TriangularGrid grid{columns, rows, spacing, std::vector<double>(columns * rows)};
    raise_hills(grid, seed);
    erode(grid, kFirstSteps, seed);
    return grid;
  }
  // Great rivers find their ways on a coarse grid, where a step costs little.
  const TriangularGrid coarse =
      eroded_grid(columns / 2 + 2 + 2 * kMargin, rows / 2 + 2 + 2 * kMargin, 2 * spacing, seed);
  TriangularGrid grid = refined(coarse, columns, rows, seed);
  erode(grid, kFurtherSteps, seed);
  return grid;
}

}  // namespace hodt
