// Any bytes, read as GeoJSON.
#include "input.h"

#include "hodt/base/error.h"
#include "hodt/io/places_file.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const hodt::fuzz::Input input({reinterpret_cast<const char*>(data), size});
  try {
    const hodt::Places places = hodt::parse_places(input.text());
    hodt::fuzz::require_sound(places.points);
    hodt::fuzz::require(places.part_of_point.size() == places.points.size());
    hodt::fuzz::require(places.part_of_polygon.size() == places.polygons.size());
    for (const auto& polygon : places.polygons)
      for (const auto& ring : polygon.rings) hodt::fuzz::require_sound(ring);
  } catch (const hodt::InputError&) {
    // What cannot be used is refused.
  }
  return 0;
}
