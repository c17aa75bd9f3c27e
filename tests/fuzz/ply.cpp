// Any bytes, read as PLY.
#include "hodt/io/ply.h"

#include "input.h"

#include "hodt/base/error.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const hodt::fuzz::Input input({reinterpret_cast<const char*>(data), size});
  try {
    hodt::fuzz::require_sound(hodt::parse_ply(input.text()));
  } catch (const hodt::InputError&) {
    // What cannot be used is refused.
  }
  return 0;
}
