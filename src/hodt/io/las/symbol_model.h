// How likely each symbol is, learnt while decoding: the adaptive model of LASzip's arithmetic
// coder (A. Said's "FastAC"). Every decoder must count and round alike, so the constants here are
// part of the format.
// Tested by tests/io/las_test.cpp.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace hodt::las {

/// A model of at most kCapacity symbols. It is empty until start().
template <std::uint32_t kCapacity>
class SymbolModel {
 public:
  /// Probabilities are in units of 2^-15.
  static constexpr std::uint32_t kShift = 15;
  static constexpr std::uint32_t kOne = 1u << kShift;

  /// Any of `symbols` symbols is as likely as any other.
  void start(std::uint32_t symbols) {
    symbols_ = symbols;
    place_shift_ = kShift - static_cast<std::uint32_t>(std::bit_width(symbols - 1));
    total_ = 0;
    cycle_ = symbols;
    std::fill_n(counts_, symbols, std::uint16_t{1});
    update();
    cycle_ = until_update_ = (symbols + 6) / 2;
  }

  std::uint32_t last_symbol() const { return symbols_ - 1; }

  /// The symbol whose part of [0, 2^15) holds `place`, which is less than 2^15.
  std::uint32_t symbol_at(std::uint32_t place) const {
    std::uint32_t symbol = first_[place >> place_shift_];
    while (bounds_[symbol + 1] <= place) ++symbol;
    return symbol;
  }
  /// Where the symbol's part begins; that of symbol + 1 is where it ends.
  std::uint32_t bound(std::uint32_t symbol) const { return bounds_[symbol]; }

  void count(std::uint32_t symbol) {
    ++counts_[symbol];
    if (--until_update_ == 0) update();
  }

 private:
  using Small = std::conditional_t<kCapacity <= 256, std::uint8_t, std::uint16_t>;
  static constexpr std::size_t kPlaces = std::bit_ceil(kCapacity);

  /// Seldom, and best kept out of the way.
  [[gnu::noinline]] void update() {
    total_ += cycle_;
    if (total_ > kOne) halve();
    // The largest total, 2^15, still leaves each count a part of at least one unit.
    const std::uint32_t scale = (1u << 31) / total_;
    std::uint32_t sum = 0;
    for (std::uint32_t s = 0; s < symbols_; ++s) {
      bounds_[s] = static_cast<std::uint16_t>((scale * sum) >> (31 - kShift));
      sum += counts_[s];
    }
    bounds_[symbols_] = kOne;
    const std::size_t places = std::min<std::size_t>(kPlaces, kOne >> place_shift_);
    for (std::uint32_t place = 0, s = 0; place < places; ++place) {
      while (bounds_[s + 1] <= place << place_shift_) ++s;
      first_[place] = static_cast<Small>(s);
    }
    cycle_ = std::min(5 * cycle_ / 4, (symbols_ + 6) * 8);
    until_update_ = cycle_;
  }

  void halve() {
    total_ = 0;
    for (std::uint32_t s = 0; s < symbols_; ++s) {
      counts_[s] = static_cast<std::uint16_t>((counts_[s] + 1) / 2);
      total_ += counts_[s];
    }
  }

  std::uint32_t symbols_;
  std::uint32_t place_shift_;
  std::uint32_t total_;
  std::uint32_t cycle_;
  std::uint32_t until_update_;
  std::uint16_t bounds_[kCapacity + 1];
  std::uint16_t counts_[kCapacity];
  Small first_[kPlaces];  ///< of each place's beginning, the symbol
};

/// The same for one bit.
class BitModel {
 public:
  static constexpr std::uint32_t kShift = 13;

  void start() { *this = BitModel(); }

  /// How likely 0 is, in units of 2^-13; more than 0, less than all.
  std::uint32_t zero() const { return zero_; }

  void count(bool one) {
    zeros_ += one ? 0 : 1;
    if (--until_update_ == 0) update();
  }

 private:
  void update() {
    total_ += cycle_;
    if (total_ > 1u << kShift) {
      total_ = (total_ + 1) / 2;
      zeros_ = (zeros_ + 1) / 2;
      if (zeros_ == total_) ++total_;
    }
    zero_ = (zeros_ * ((1u << 31) / total_)) >> (31 - kShift);
    cycle_ = std::min(5 * cycle_ / 4, 64u);
    until_update_ = cycle_;
  }

  std::uint32_t zeros_ = 1;
  std::uint32_t total_ = 2;
  std::uint32_t zero_ = 1u << (kShift - 1);
  std::uint32_t cycle_ = 4;
  std::uint32_t until_update_ = 4;
};

/// Models of `count` kinds, each started when it is first asked for: most never are.
template <std::uint32_t kSymbols, std::size_t kCount>
class SymbolModels {
 public:
  void forget() { std::fill_n(started_, kCount, false); }

  SymbolModel<kSymbols>& operator[](std::size_t i) {
    if (!started_[i]) {
      models_[i].start(kSymbols);
      started_[i] = true;
    }
    return models_[i];
  }

 private:
  bool started_[kCount] = {};
  SymbolModel<kSymbols> models_[kCount];
};

}  // namespace hodt::las
