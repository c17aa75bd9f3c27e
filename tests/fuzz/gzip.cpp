// Any bytes, unpacked; and any bytes, packed and unpacked again.
#include "hodt/io/gzip.h"

#include "input.h"

#include "hodt/base/error.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hodt;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const fuzz::Input input(bytes);
  try {
    if (is_gzip(bytes)) gunzip(input.text());
  } catch (const InputError&) {
    // What is damaged is refused.
  }
  const Buffer<char> packed = gzip(bytes);
  const fuzz::Input again({packed.data(), packed.size()});
  fuzz::require(gunzip(again.text()).view() == bytes);
  return 0;
}
