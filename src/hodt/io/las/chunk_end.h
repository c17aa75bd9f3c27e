// Compressed points have no checksum, but damage makes them take more or fewer bytes than there
// are.
// Tested by tests/io/las_damage_test.cpp.
#pragma once

#include <fmt/format.h>

#include "hodt/io/las/arithmetic_decoder.h"

namespace hodt::las {

/// Throws Damage if many bytes are left where the last point was decoded.
inline void check_end(const ArithmeticDecoder& in) {
  // Known encoders leave none.
  constexpr std::size_t most = 8;
  if (in.left() > most)
    throw Damage{fmt::format("its points are decoded, and {} of its bytes are left", in.left())};
}

}  // namespace hodt::las
