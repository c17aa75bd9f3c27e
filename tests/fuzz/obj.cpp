// Any bytes, read as OBJ.
#include "hodt/io/obj.h"

#include "input.h"

#include "hodt/base/error.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const hodt::fuzz::Input input({reinterpret_cast<const char*>(data), size});
  try {
    hodt::fuzz::require_sound(hodt::parse_obj(input.text()));
  } catch (const hodt::InputError&) {
    // What cannot be used is refused.
  }
  return 0;
}
