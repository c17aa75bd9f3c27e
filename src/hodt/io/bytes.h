// Numbers as bytes of files.
// Tested by tests/io/tin_writers_test.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace hodt {

/// Writes the number in the order of bytes that the file has, whatever the machine's is; returns
/// the end.
template <std::endian Order, class T>
char* put_bytes(char* to, T value) {
  auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if constexpr (Order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  std::memcpy(to, bytes.data(), sizeof(T));
  return to + sizeof(T);
}

template <class T>
char* put_little(char* to, T value) {
  return put_bytes<std::endian::little>(to, value);
}

template <class T>
char* put_big(char* to, T value) {
  return put_bytes<std::endian::big>(to, value);
}

}  // namespace hodt
