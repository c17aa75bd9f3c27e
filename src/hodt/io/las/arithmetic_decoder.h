// The arithmetic decoder of LASzip: 32 bits, a byte at a time.
//
// What the data claim is never trusted: reading past their end throws, and no data make a length
// zero or an index too large. Each model leaves every symbol a part, the length is at least 2^24
// between two symbols, and the value is always less than the length.
// Tested by tests/io/las_test.cpp.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "hodt/io/las/damage.h"
#include "hodt/io/las/symbol_model.h"

namespace hodt::las {

class ArithmeticDecoder {
 public:
  ArithmeticDecoder() = default;
  /// Four bytes past `end` have to be readable.
  ArithmeticDecoder(const char* begin, const char* end)
      : next_(reinterpret_cast<const unsigned char*>(begin)),
        end_(reinterpret_cast<const unsigned char*>(end)) {
    value_ = shifted_in(0, 32);
    if (value_ == kLongest) throw Damage{"its data begin as none do"};
  }

  template <std::uint32_t kCapacity>
  std::uint32_t symbol(SymbolModel<kCapacity>& model) {
    using Model = SymbolModel<kCapacity>;
    const std::uint32_t unit = length_ >> Model::kShift;
    // The last symbol also has what rounding leaves over.
    const std::uint32_t place = std::min(value_ / unit, Model::kOne - 1);
    const std::uint32_t symbol = model.symbol_at(place);
    const std::uint32_t low = model.bound(symbol) * unit;
    const std::uint32_t high =
        symbol == model.last_symbol() ? length_ : model.bound(symbol + 1) * unit;
    value_ -= low;
    length_ = high - low;
    renormalize();
    model.count(symbol);
    return symbol;
  }

  bool bit(BitModel& model) {
    const std::uint32_t cut = model.zero() * (length_ >> BitModel::kShift);
    const bool one = value_ >= cut;
    value_ -= one ? cut : 0;
    length_ = one ? length_ - cut : cut;
    renormalize();
    model.count(one);
    return one;
  }

  /// `count` bits that no model knows, at most 32.
  std::uint32_t bits(std::uint32_t count) {
    constexpr std::uint32_t most = 19, low = 16;
    if (count <= most) return few_bits(count);
    const std::uint32_t lower = few_bits(low);
    return few_bits(count - low) << low | lower;
  }

  /// The bytes that were not asked for.
  std::size_t left() const { return static_cast<std::size_t>(end_ - next_); }

 private:
  static constexpr std::uint32_t kLongest = 0xFFFFFFFF;
  static constexpr std::uint32_t kShortest = 1u << 24;

  std::uint32_t few_bits(std::uint32_t count) {
    length_ >>= count;
    const std::uint32_t found = value_ / length_;
    if (found >> count) throw Damage{"its data are no numbers"};
    value_ -= found * length_;
    renormalize();
    return found;
  }

  void renormalize() {
    if (length_ >= kShortest) return;
    // Whole bytes, until the highest byte of the length is not zero.
    const auto shift = static_cast<std::uint32_t>(std::countl_zero(length_)) & 24u;
    value_ = shifted_in(value_, shift);
    length_ <<= shift;
  }

  /// The value with the next shift / 8 bytes behind it; 0 < shift <= 32.
  std::uint32_t shifted_in(std::uint32_t value, std::uint32_t shift) {
    if (left() < shift / 8) throw_end();
    const std::uint64_t four = std::uint64_t{next_[0]} << 24 | std::uint64_t{next_[1]} << 16 |
                               std::uint64_t{next_[2]} << 8 | std::uint64_t{next_[3]};
    next_ += shift / 8;
    return static_cast<std::uint32_t>(((std::uint64_t{value} << 32 | four) << shift) >> 32);
  }

  [[noreturn, gnu::noinline]] static void throw_end() { throw Damage{"its data end too early"}; }

  std::uint32_t value_ = 0;
  std::uint32_t length_ = kLongest;
  const unsigned char* next_ = nullptr;
  const unsigned char* end_ = nullptr;
};

}  // namespace hodt::las
