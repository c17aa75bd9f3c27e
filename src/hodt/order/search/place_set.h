// Sets of small numbers, a bit each.
// Tested by tests/order/near_points_test.cpp.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "hodt/base/ids.h"

namespace hodt {

/// A set of places 0 to 64 kWords - 1.
template <Index kWords>
class PlaceSet {
 public:
  static constexpr Index kMost = 64 * kWords;

  /// The set of that place only.
  static constexpr PlaceSet only(Index place) {
    PlaceSet set;
    set.words_[word_of(place)] = std::uint64_t{1} << place % 64;
    return set;
  }
  /// The set of the first so many places.
  static constexpr PlaceSet first(Index size) {
    PlaceSet set;
    for (Index w = 0; w < kWords; ++w)
      set.words_[w] = size >= 64 * (w + 1) ? ~std::uint64_t{0}
                      : size > 64 * w      ? (std::uint64_t{1} << size % 64) - 1
                                           : 0;
    return set;
  }

  constexpr bool has(Index place) const { return (words_[word_of(place)] >> place % 64 & 1) != 0; }
  constexpr bool is_empty() const {
    std::uint64_t any = 0;
    for (const std::uint64_t word : words_) any |= word;
    return any == 0;
  }
  constexpr Index count() const {
    int count = 0;
    for (const std::uint64_t word : words_) count += std::popcount(word);
    return static_cast<Index>(count);
  }
  /// Asks f(place) for one place after another, in order, until it is true.
  template <class F>
  constexpr bool any_of(const F& f) const {
    for (Index w = 0; w < kWords; ++w)
      for (std::uint64_t rest = words_[w]; rest != 0; rest &= rest - 1)
        if (f(64 * w + static_cast<Index>(std::countr_zero(rest)))) return true;
    return false;
  }
  template <class F>
  constexpr void for_each(const F& f) const {
    any_of([&](Index place) {
      f(place);
      return false;
    });
  }

  /// The places 64 w to 64 w + 63.
  constexpr std::uint64_t& word(Index w) { return words_[w]; }
  constexpr PlaceSet& operator|=(const PlaceSet& other) {
    for (Index w = 0; w < kWords; ++w) words_[w] |= other.words_[w];
    return *this;
  }
  constexpr PlaceSet& operator&=(const PlaceSet& other) {
    for (Index w = 0; w < kWords; ++w) words_[w] &= other.words_[w];
    return *this;
  }
  /// Without those of the other set.
  constexpr PlaceSet& operator-=(const PlaceSet& other) {
    for (Index w = 0; w < kWords; ++w) words_[w] &= ~other.words_[w];
    return *this;
  }
  friend constexpr PlaceSet operator|(PlaceSet a, const PlaceSet& b) { return a |= b; }
  friend constexpr PlaceSet operator&(PlaceSet a, const PlaceSet& b) { return a &= b; }
  friend constexpr PlaceSet operator-(PlaceSet a, const PlaceSet& b) { return a -= b; }
  friend constexpr bool operator==(const PlaceSet&, const PlaceSet&) = default;

 private:
  /// A constant where it is one: a set of one word lives in a register then.
  static constexpr Index word_of(Index place) { return kWords == 1 ? 0 : place / 64; }

  std::array<std::uint64_t, kWords> words_{};
};

}  // namespace hodt
