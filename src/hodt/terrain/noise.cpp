#include "hodt/terrain/noise.h"

#include "hodt/terrain/random.h"

namespace hodt {
namespace {

/// From 0 at 0 to 1 at 1 with first and second derivative zero at both ends: no creases at the
/// lattice lines.
double ease(double t) {
  return t * t * t * (t * (t * 6 - 15) + 10);
}

double lattice_value(std::uint64_t column, std::uint64_t row, std::uint64_t seed) {
  return 2 * random_unit(seed, (row << 32) | column) - 1;
}

/// Random values at the integer points, eased in between.
double smooth_noise(double x, double y, std::uint64_t seed) {
  const auto column = static_cast<std::uint64_t>(x);
  const auto row = static_cast<std::uint64_t>(y);
  const double u = ease(x - static_cast<double>(column));
  const double v = ease(y - static_cast<double>(row));
  const double south =
      lattice_value(column, row, seed) * (1 - u) + lattice_value(column + 1, row, seed) * u;
  const double north =
      lattice_value(column, row + 1, seed) * (1 - u) + lattice_value(column + 1, row + 1, seed) * u;
  return south * (1 - v) + north * v;
}

}  // namespace

double fractal_noise(double x, double y, int octaves, std::uint64_t seed) {
  double sum = 0;
  double weight = 0;
  double amplitude = 1;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += amplitude * smooth_noise(x, y, derived_seed(seed, static_cast<std::uint64_t>(octave)));
    weight += amplitude;
    amplitude /= 2;
    // The shift keeps the lattices of the octaves from meeting at the origin.
    x = 2 * x + 17.3;
    y = 2 * y + 9.1;
  }
  return sum / weight;
}

}  // namespace hodt
