// Any bytes, read as GeoJSON of lines and of an outline.
#include "input.h"

#include "hodt/base/error.h"
#include "hodt/io/line_file.h"

namespace {

void require_sound(const std::vector<hodt::Line>& lines) {
  using hodt::fuzz::require;
  require(!lines.empty());
  for (const hodt::Line& line : lines) {
    hodt::fuzz::require_sound(hodt::PointSet{line.xy, line.z});
    require(line.xy.size() > 1 && line.part > 0);
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const hodt::fuzz::Input input({reinterpret_cast<const char*>(data), size});
  try {
    require_sound(hodt::parse_lines(input.text()).lines);
  } catch (const hodt::InputError&) {
    // What cannot be used is refused.
  }
  try {
    const hodt::Outline outline = hodt::parse_outline(input.text());
    require_sound(outline.rings);
    for (const hodt::Line& ring : outline.rings)
      hodt::fuzz::require(ring.is_closed() && ring.xy.size() > 3);
  } catch (const hodt::InputError&) {
    // Likewise.
  }
  return 0;
}
