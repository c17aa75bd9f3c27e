// Random numbers that are the same on every machine and for every number of threads.
//
// The standard library's distributions differ between vendors, and a generator with a state ties a
// value to the order in which values are drawn. Here the i-th number is a function of (seed, i).
// Tested by tests/terrain/terrain_test.cpp.
#pragma once

#include <cstdint>

namespace hodt {

/// The i-th of a sequence of 64 random bits: SplitMix64 (Steele, Lea, Flood 2014) at position i.
inline std::uint64_t random_bits(std::uint64_t seed, std::uint64_t i) {
  std::uint64_t bits = seed + (i + 1) * 0x9e3779b97f4a7c15u;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  return bits ^ (bits >> 31);
}

/// An integer in [0, bound), nearly uniform: no value is preferred by more than bound / 2^32.
inline std::uint32_t random_below(std::uint32_t bound, std::uint64_t seed, std::uint64_t i) {
  return static_cast<std::uint32_t>(((random_bits(seed, i) >> 32) * bound) >> 32);
}

/// A number in [0, 1).
inline double random_unit(std::uint64_t seed, std::uint64_t i) {
  return static_cast<double>(random_bits(seed, i) >> 11) * 0x1p-53;
}

/// A seed for an independent sequence, so that uses of one user's seed do not share numbers.
inline std::uint64_t derived_seed(std::uint64_t seed, std::uint64_t purpose) {
  return random_bits(random_bits(seed, purpose), ~purpose);
}

}  // namespace hodt
