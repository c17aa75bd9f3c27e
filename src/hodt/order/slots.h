// Points near a vertex u, and questions to all of them at once, answered as bit masks.
//
// The answers are proofs, not decisions: a bit that is set is certainly right, a point that
// rounding leaves in doubt has no bit. Nothing is ever decided by a missing bit.
#pragma once

#include <array>
#include <cstdint>

#include "hodt/base/ids.h"

namespace hodt {

/// A set of up to 64 * kWords slots.
template <int kWords>
struct SlotMask {
  std::array<std::uint64_t, kWords> words{};

  static SlotMask only(Index slot) {
    SlotMask mask;
    mask.words[slot / 64] = std::uint64_t{1} << slot % 64;
    return mask;
  }
  bool contains(Index slot) const { return words[slot / 64] >> slot % 64 & 1; }
  Index count() const {
    Index sum = 0;
    for (const std::uint64_t word : words) sum += count_bits(word);
    return sum;
  }
  SlotMask& operator|=(const SlotMask& other) {
    for (int i = 0; i < kWords; ++i) words[i] |= other.words[i];
    return *this;
  }
  friend SlotMask operator|(SlotMask a, const SlotMask& b) { return a |= b; }
  friend SlotMask operator&(SlotMask a, const SlotMask& b) {
    for (int i = 0; i < kWords; ++i) a.words[i] &= b.words[i];
    return a;
  }

 private:
  /// std::popcount, which without an instruction for it is a call.
  static Index count_bits(std::uint64_t v) {
    v -= (v >> 1) & 0x5555555555555555u;
    v = (v & 0x3333333333333333u) + ((v >> 2) & 0x3333333333333333u);
    v = (v + (v >> 4)) & 0x0F0F0F0F0F0F0F0Fu;
    return static_cast<Index>((v * 0x0101010101010101u) >> 56);
  }
};

template <int kWords>
class Slots {
 public:
  static constexpr Index kCapacity = 64 * kWords;
  using Mask = SlotMask<kWords>;

  /// What lies certainly to the left and to the right of a ray from u.
  struct Sides {
    Mask left, right;
  };

  Index size() const { return size_; }
  void clear() { size_ = 0; }
  /// Adds the point u + (x, y). Requires size() < kCapacity.
  void add(double x, double y);

  /// Points certainly inside the circle through u, u + b and u + c. Requires b, c in
  /// counter-clockwise order as seen from u.
  Mask inside_circle(double bx, double by, double cx, double cy) const;
  /// Points certainly on either side of the line through u and u + (x, y).
  Sides sides_of_ray(double x, double y) const;

 private:
  static constexpr Index kBlock = 8;  // arrays are filled up to a multiple of this

  /// The slots with q_r r + q_x x + q_y y + constant < 0.
  Mask negative(double q_r, double q_x, double q_y, double constant) const;

  Index size_ = 0;
  alignas(64) std::array<double, kCapacity> x_, y_, r_;  // r = x² + y²
};

extern template class Slots<1>;
extern template class Slots<4>;
extern template class Slots<16>;

}  // namespace hodt
