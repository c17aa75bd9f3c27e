// Smooth random hills over the plane.
// Tested by tests/terrain/terrain_test.cpp.
#pragma once

#include <cstdint>

namespace hodt {

/// Sum of `octaves` layers of smooth noise: the first has hills about one unit apart, each further
/// one half as wide and half as high. Between -1 and 1, mean 0. Takes x, y >= 0.
double fractal_noise(double x, double y, int octaves, std::uint64_t seed);

}  // namespace hodt
