#include "hodt/io/glb.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>

#include <nlohmann/json.hpp>

#include "hodt/base/error.h"
#include "hodt/io/bytes.h"
#include "hodt/io/local_frame.h"
#include "hodt/io/parallel_text.h"

namespace hodt {

namespace {

using Json = nlohmann::ordered_json;
using Position = std::array<float, 3>;

// Numbers of the format.
constexpr std::uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr int kVertices = 34962, kIndices = 34963, kFloat = 5126, kUnsignedInt = 5125;

/// As glTF turns its axes.
template <class T>
std::array<T, 3> turned(const std::array<T, 3>& place) {
  return {place[0], place[2], T{0} - place[1]};
}

/// The smallest and the largest value of each coordinate.
std::array<Position, 2> range_of(const LocalFrame& frame, std::size_t count) {
  Position least, most;
  least.fill(std::numeric_limits<float>::max());
  most.fill(std::numeric_limits<float>::lowest());
  for (std::size_t i = 0; i < count; ++i) {
    const Position at = turned(frame[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      least[k] = std::min(least[k], at[k]);
      most[k] = std::max(most[k], at[k]);
    }
  }
  return {least, most};
}

std::string description(const Tin& tin, const LocalFrame& frame) {
  const std::size_t points = tin.points.size(), corners = 3 * tin.triangles.size();
  const std::size_t position_bytes = points * sizeof(Position);
  const auto [least, most] = range_of(frame, points);
  Json extras = {{"origin", frame.origin()}};
  if (!tin.crs.empty()) extras["crs"] = tin.crs;
  const Json json = {
      {"asset", {{"version", "2.0"}, {"generator", "hodt"}}},
      {"scene", 0},
      {"scenes", {{{"nodes", {0}}}}},
      {"nodes",
       {{{"name", "terrain"},
         {"mesh", 0},
         {"translation", turned(frame.origin())},
         {"extras", extras}}}},
      {"meshes",
       {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}, {"material", 0}}}}}}},
      {"materials", {{{"doubleSided", true}, {"pbrMetallicRoughness", {{"metallicFactor", 0}}}}}},
      {"accessors",
       {{{"bufferView", 0},
         {"componentType", kFloat},
         {"count", points},
         {"type", "VEC3"},
         {"min", least},
         {"max", most}},
        {{"bufferView", 1},
         {"componentType", kUnsignedInt},
         {"count", corners},
         {"type", "SCALAR"}}}},
      {"bufferViews",
       {{{"buffer", 0}, {"byteLength", position_bytes}, {"target", kVertices}},
        {{"buffer", 0},
         {"byteOffset", position_bytes},
         {"byteLength", corners * sizeof(std::uint32_t)},
         {"target", kIndices}}}},
      {"buffers", {{{"byteLength", position_bytes + corners * sizeof(std::uint32_t)}}}}};
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.resize((text.size() + 3) / 4 * 4, ' ');
  return text;
}

void write_numbers(OutputFile& file, std::initializer_list<std::uint32_t> numbers) {
  for (const std::uint32_t number : numbers) {
    char bytes[sizeof number];
    put_little(bytes, number);
    file.write({bytes, sizeof bytes});
  }
}

}  // namespace

void write_glb(const Tin& tin, OutputFile& file) {
  const PointSet& points = tin.points;
  const LocalFrame frame(tin);
  const std::string json = description(tin, frame);
  const std::size_t binary = 12 * points.size() + 12 * tin.triangles.size();
  const std::size_t total = 12 + 8 + json.size() + 8 + binary;
  if (total > std::numeric_limits<std::uint32_t>::max())
    throw InputError("a GLB file holds 4 GiB at most, and the mesh takes more; write .ply");
  write_numbers(file, {kMagic, 2, static_cast<std::uint32_t>(total)});
  write_numbers(file, {static_cast<std::uint32_t>(json.size()), kJsonChunk});
  file.write(json);
  write_numbers(file, {static_cast<std::uint32_t>(binary), kBinaryChunk});
  write_records(file, points.size(), 12, [&](std::size_t i, char* to) {
    for (const float value : turned(frame[i])) to = put_little(to, value);
    return to;
  });
  write_records(file, tin.triangles.size(), 12, [&](std::size_t t, char* to) {
    for (const Index corner : tin.triangles[t]) to = put_little(to, corner);
    return to;
  });
}

}  // namespace hodt
