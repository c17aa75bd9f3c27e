#include "hodt/io/las/laz_layout.h"

#include <algorithm>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/las/little_endian.h"
#include "hodt/io/las/raw_point.h"

namespace hodt::las {

namespace {

using Kind = LazItemKind;

[[noreturn]] void fail(const LasHeader& header, const std::string& what) {
  throw InputError(fmt::format("{}: its record 'laszip encoded' {}", header.name, what));
}

std::uint16_t size_of(Kind kind) {
  switch (kind) {
    case Kind::point10:
      return 20;
    case Kind::gps_time11:
      return 8;
    case Kind::rgb12:
    case Kind::rgb14:
      return 6;
    case Kind::wave_packet13:
    case Kind::wave_packet14:
      return 29;
    case Kind::point14:
      return 30;
    case Kind::rgb_nir14:
      return 8;
    case Kind::bytes:
    case Kind::bytes14:
      return 0;  // any
  }
  return 0;
}

/// What a point of the format is made of, but for extra bytes.
std::vector<Kind> items_of(int format) {
  switch (format) {
    case 0:
      return {Kind::point10};
    case 1:
      return {Kind::point10, Kind::gps_time11};
    case 2:
      return {Kind::point10, Kind::rgb12};
    case 3:
      return {Kind::point10, Kind::gps_time11, Kind::rgb12};
    case 4:
      return {Kind::point10, Kind::gps_time11, Kind::wave_packet13};
    case 5:
      return {Kind::point10, Kind::gps_time11, Kind::rgb12, Kind::wave_packet13};
    case 6:
      return {Kind::point14};
    case 7:
      return {Kind::point14, Kind::rgb14};
    case 8:
      return {Kind::point14, Kind::rgb_nir14};
    case 9:
      return {Kind::point14, Kind::wave_packet14};
    default:
      return {Kind::point14, Kind::rgb_nir14, Kind::wave_packet14};
  }
}

void check_item(const LasHeader& header, const LazItem& item, bool is_layered) {
  const std::uint16_t size = size_of(item.kind);
  if (size != 0 && item.size != size)
    fail(header, fmt::format("gives an item of kind {} the size {}", int(item.kind), item.size));
  // Version 4 differs from 3 in items that are gone past; of wave packets, 1 and 2 are the same.
  // Extra bytes had another version 1, of which no file could be found.
  const bool is_old = item.version == 1 && item.kind != Kind::bytes;
  const bool known =
      is_layered ? item.version == 3 || item.version == 4 : is_old || item.version == 2;
  if (!known)
    fail(header,
         fmt::format("names version {} of item {}, which hodt does not read; write the file again "
                     "with laszip, or as LAS",
                     item.version, int(item.kind)));
}

/// The items are those of the point format, and then extra bytes.
void check_items(const LasHeader& header, const LazLayout& layout) {
  const bool is_layered = layout.compressor == LazLayout::layered_chunked;
  const std::vector<Kind> wanted = items_of(header.format);
  const Kind extra = is_layered ? Kind::bytes14 : Kind::bytes;
  for (std::size_t i = 0; i < layout.items.size(); ++i) {
    const Kind kind = layout.items[i].kind;
    if (i < wanted.size() ? kind != wanted[i] : kind != extra)
      fail(header, fmt::format("names item {} where a point of format {} has none", int(kind),
                               header.format));
    check_item(header, layout.items[i], is_layered);
  }
  if (layout.items.size() < wanted.size())
    fail(header, fmt::format("lacks items of a point of format {}", header.format));
  if (layout.point_size != header.point_size)
    fail(header, fmt::format("has points of {} bytes, and the header of {}", layout.point_size,
                             header.point_size));
}

}  // namespace

LazLayout parse_laz_layout(const LasHeader& header, std::string_view record) {
  constexpr std::size_t start = 34, item_size = 6;
  if (record.size() < start) fail(header, fmt::format("has only {} bytes", record.size()));
  LazLayout layout;
  layout.compressor = number_at<std::uint16_t>(record.data());
  layout.chunk_points = number_at<std::uint32_t>(record.data() + 12);
  if (layout.chunk_points == 0) layout.chunk_points = LazLayout::kVariable;
  const bool is_long = header.format >= kFirstLongFormat;
  const bool known = is_long ? layout.compressor == LazLayout::layered_chunked
                             : layout.compressor == LazLayout::pointwise ||
                                   layout.compressor == LazLayout::pointwise_chunked;
  const auto coder = number_at<std::uint16_t>(record.data() + 2);
  if (!known || coder != 0)
    fail(header,
         fmt::format("names compressor {} with coder {} for points of format {}, which hodt does "
                     "not read; write the file again with laszip, or as LAS",
                     layout.compressor, coder, header.format));
  const std::size_t count = number_at<std::uint16_t>(record.data() + 32);
  if (record.size() < start + count * item_size)
    fail(header, fmt::format("announces {} items, but ends before", count));
  for (std::size_t i = 0; i < count; ++i) {
    const char* const from = record.data() + start + i * item_size;
    layout.items.push_back({static_cast<LazItemKind>(number_at<std::uint16_t>(from)),
                            number_at<std::uint16_t>(from + 2),
                            number_at<std::uint16_t>(from + 4)});
    layout.point_size += layout.items.back().size;
  }
  check_items(header, layout);
  return layout;
}

}  // namespace hodt::las
