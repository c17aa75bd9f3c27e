#include "hodt/picture/relief.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hodt {
namespace {

struct Stop {
  double at;
  double red, green, blue;
};

// Muted, and light enough for lines on it: sage, straw, sand, clay, chalk.
constexpr Stop kRamp[] = {{0.00, 163, 184, 160},
                          {0.20, 193, 203, 172},
                          {0.45, 224, 214, 184},
                          {0.75, 207, 181, 151},
                          {1.00, 232, 226, 218}};

constexpr double kTintSteps = 14;
constexpr double kShadeSteps = 10;

std::uint8_t channel(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

Colour tint_times(double share, double light) {
  share = std::clamp(share, 0.0, 1.0);
  const Stop* high = kRamp + 1;
  while (high->at < share) ++high;
  const Stop* low = high - 1;
  const double t = (share - low->at) / (high->at - low->at);
  return {channel((low->red + t * (high->red - low->red)) * light),
          channel((low->green + t * (high->green - low->green)) * light),
          channel((low->blue + t * (high->blue - low->blue)) * light)};
}

/// How bright a slope is under a lamp in the north-west, 45 degrees high; 1 on the level.
double brightness(double slope_x, double slope_y) {
  const double facing = 1 + (slope_x - slope_y) * std::sqrt(0.5);
  const double lambert = facing / std::sqrt(1 + slope_x * slope_x + slope_y * slope_y);
  return std::clamp(lambert, 0.0, 1.3);
}

}  // namespace

Colour tint(double share) {
  return tint_times(share, 1);
}

Colour shaded(double share, double slope_x, double slope_y) {
  const double step = std::floor(brightness(slope_x, slope_y) * kShadeSteps + 0.5) / kShadeSteps;
  return tint_times(std::floor(share * kTintSteps + 0.5) / kTintSteps, 0.70 + 0.30 * step);
}

}  // namespace hodt
