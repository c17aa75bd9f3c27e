#include "hodt/io/well_known_binary.h"

#include <bit>

namespace hodt {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie");

void append_position(std::string& bytes, const LayerFeature& feature, std::size_t i) {
  append_raw(bytes, feature.xy[i]);
  if (!feature.z.empty()) append_raw(bytes, feature.z[i]);
}

}  // namespace

WellKnownBinary::WellKnownBinary(const FeatureLayer& layer) : kind_(layer.geometry) {
  constexpr char little_endian = 1;
  constexpr std::uint32_t first_kind = 1, with_heights = 1000, rings = 1;
  head_ += little_endian;
  append_raw(head_, first_kind + static_cast<std::uint32_t>(kind_) +
                        (layer.has_heights ? with_heights : 0));
  if (kind_ == GeometryKind::polygon) append_raw(head_, rings);
}

void WellKnownBinary::append(std::string& bytes, const LayerFeature& feature) const {
  bytes += head_;
  const bool is_ring = kind_ == GeometryKind::polygon;
  if (kind_ != GeometryKind::point)
    append_raw(bytes, static_cast<std::uint32_t>(feature.xy.size() + (is_ring ? 1 : 0)));
  for (std::size_t i = 0; i < feature.xy.size(); ++i) append_position(bytes, feature, i);
  if (is_ring) append_position(bytes, feature, 0);
}

}  // namespace hodt
