// How a LAZ file is compressed: what the record "laszip encoded" says.
// Tested by tests/io/las_test.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "hodt/io/las/las_header.h"

namespace hodt::las {

enum class LazItemKind : std::uint16_t {
  bytes = 0,
  point10 = 6,
  gps_time11 = 7,
  rgb12 = 8,
  wave_packet13 = 9,
  point14 = 10,
  rgb14 = 11,
  rgb_nir14 = 12,
  wave_packet14 = 13,
  bytes14 = 14,
};

struct LazItem {
  LazItemKind kind;
  std::uint16_t size;  ///< in the uncompressed point
  std::uint16_t version;
};

struct LazLayout {
  enum Compressor : std::uint16_t { pointwise = 1, pointwise_chunked = 2, layered_chunked = 3 };
  static constexpr std::uint32_t kVariable = 0xFFFFFFFF;

  std::uint16_t compressor = 0;
  std::uint32_t chunk_points = 0;  ///< kVariable if each chunk has its own number
  std::vector<LazItem> items;
  std::size_t point_size = 0;
};

/// Throws InputError if the record is damaged, does not fit the header's point format, or is of a
/// kind that hodt does not know.
LazLayout parse_laz_layout(const LasHeader& header, std::string_view record);

}  // namespace hodt::las
