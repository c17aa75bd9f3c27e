// Numbers in the bytes of a LAS file, which are little-endian whatever the machine is.
// Tested by tests/io/las_test.cpp.
#pragma once

#include <algorithm>
#include <bit>
#include <cstring>

namespace hodt::las {

/// The number that begins at `from`, which need not be aligned.
template <class T>
T number_at(const char* from) {
  T value;
  if constexpr (std::endian::native == std::endian::little) {
    std::memcpy(&value, from, sizeof(T));
  } else {
    char bytes[sizeof(T)];
    std::reverse_copy(from, from + sizeof(T), bytes);
    std::memcpy(&value, bytes, sizeof(T));
  }
  return value;
}

}  // namespace hodt::las
