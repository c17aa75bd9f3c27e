// Integers coded as corrections of a prediction: first the number of bits of the correction, then
// the bits, of which the higher ones have models.
// Tested by tests/io/las_test.cpp.
#pragma once

#include <cstdint>

#include "hodt/io/las/arithmetic_decoder.h"

namespace hodt::las {

/// Modulo 2^32, as LASzip adds.
inline std::int32_t wrapped_sum(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
}

/// Of kBits bits, each decoded in one of kContexts contexts.
template <std::uint32_t kBits, std::uint32_t kContexts>
class IntegerDecoder {
 public:
  void forget() {
    sizes_.forget();
    corrections_.forget();
    tiny_.start();
  }

  /// The next correction, as a number modulo 2^32.
  std::uint32_t correction(ArithmeticDecoder& in, std::uint32_t context) {
    const std::uint32_t bits = in.symbol(sizes_[context]);
    last_bits_ = bits;
    if (bits == 0) return in.bit(tiny_);
    if (kBits == 32 && bits == 32) return std::uint32_t{1} << 31;
    std::uint32_t found = in.symbol(corrections_.of_bits(bits));
    if (kBits > kModelled && bits > kModelled)
      found = found << (bits - kModelled) | in.bits(bits - kModelled);
    // Corrections of this size are -(2^bits - 1) to -2^(bits-1), and 2^(bits-1) + 1 to 2^bits.
    return found >> (bits - 1) ? found + 1 : found - ((std::uint32_t{1} << bits) - 1);
  }

  /// The next integer.
  std::int32_t next(ArithmeticDecoder& in, std::int32_t prediction, std::uint32_t context) {
    static_assert(kBits == 32, "shorter integers are not needed, and wrap otherwise");
    return wrapped_sum(prediction, static_cast<std::int32_t>(correction(in, context)));
  }

  /// How many bits the last correction had.
  std::uint32_t last_bits() const { return last_bits_; }

 private:
  static constexpr std::uint32_t kModelled = 8;

  /// A model for each number of bits, of so many symbols as the modelled bits have values.
  class Corrections {
   public:
    void forget() { std::fill_n(started_, kBits, false); }
    SymbolModel<1u << kModelled>& of_bits(std::uint32_t bits) {
      if (!started_[bits - 1]) {
        models_[bits - 1].start(1u << std::min(bits, kModelled));
        started_[bits - 1] = true;
      }
      return models_[bits - 1];
    }

   private:
    bool started_[kBits] = {};
    SymbolModel<1u << kModelled> models_[kBits];
  };

  std::uint32_t last_bits_ = 0;
  BitModel tiny_;
  SymbolModels<kBits + 1, kContexts> sizes_;
  Corrections corrections_;
};

}  // namespace hodt::las
