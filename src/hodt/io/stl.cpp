#include "hodt/io/stl.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/bytes.h"
#include "hodt/io/local_frame.h"
#include "hodt/io/parallel_text.h"

namespace hodt {

namespace {

using Vector = std::array<float, 3>;

/// Of length one; zero for a triangle without an area.
Vector normal_of(const Vector& a, const Vector& b, const Vector& c) {
  const auto along = [&](const Vector& to, std::size_t k) { return double{to[k]} - double{a[k]}; };
  const auto part = [&](std::size_t i, std::size_t j) {
    return along(b, i) * along(c, j) - along(b, j) * along(c, i);
  };
  const double x = part(1, 2), y = part(2, 0), z = part(0, 1);
  const double length = std::hypot(x, y, z);
  if (!(length > 0) || !std::isfinite(length)) return {};
  return {static_cast<float>(x / length), static_cast<float>(y / length),
          static_cast<float>(z / length)};
}

std::string header_of(const LocalFrame& frame) {
  const auto& [x, y, z] = frame.origin();
  std::string header = fmt::format("hodt, coordinates from {:.15g} {:.15g} {:.15g}", x, y, z);
  header.resize(80, ' ');
  return header;
}

}  // namespace

void write_stl(const Tin& tin, OutputFile& file) {
  if (tin.triangles.size() > std::numeric_limits<std::uint32_t>::max())
    throw InputError("STL holds 4294967295 triangles at most; write .ply");
  const LocalFrame frame(tin);
  file.write(header_of(frame));
  char count[sizeof(std::uint32_t)];
  put_little(count, static_cast<std::uint32_t>(tin.triangles.size()));
  file.write({count, sizeof count});
  write_records(file, tin.triangles.size(), 50, [&](std::size_t t, char* to) {
    const auto& [a, b, c] = tin.triangles[t];
    const Vector corners[] = {frame[a], frame[b], frame[c]};
    const auto put = [&](const Vector& vector) {
      for (const float value : vector) to = put_little(to, value);
    };
    put(normal_of(corners[0], corners[1], corners[2]));
    for (const Vector& corner : corners) put(corner);
    return put_little(to, std::uint16_t{0});
  });
}

}  // namespace hodt
