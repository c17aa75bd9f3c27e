// What decoders throw when the compressed data cannot be true. They know neither the file nor the
// chunk, so whoever runs them makes an InputError of it.
// Tested by tests/io/las_damage_test.cpp.
#pragma once

#include <string>

namespace hodt::las {

struct Damage {
  std::string what;  ///< like "its data end too early"
};

}  // namespace hodt::las
