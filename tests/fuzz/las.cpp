// Any bytes, read as LAS or LAZ.
#include "input.h"

#include "hodt/base/error.h"
#include "hodt/io/las/las_reader.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const hodt::fuzz::Input input({reinterpret_cast<const char*>(data), size});
  try {
    const hodt::LasPoints las = hodt::read_las(input.text());
    hodt::fuzz::require(las.points.size() > 0 && las.points.has_heights());
    hodt::fuzz::require_sound(las.points);
    hodt::fuzz::require(las.points.size() == las.counts.taken);
    hodt::fuzz::require(las.counts.taken + las.counts.withheld + las.counts.other_class +
                            las.counts.other_return ==
                        las.counts.total);
  } catch (const hodt::InputError&) {
    // What cannot be used is refused.
  }
  return 0;
}
