// A point as a LAS file stores it, of which hodt needs this much.
// Tested by tests/io/las_test.cpp.
#pragma once

#include <cstdint>

#include "hodt/io/las/little_endian.h"

namespace hodt::las {

struct RawPoint {
  std::int32_t x, y, z;
  std::uint8_t point_class;
  bool withheld;
  bool first_return;
  bool last_return;
};

/// The bytes of a point, without what an extra record may add.
inline constexpr int kPointFormats = 11;
inline constexpr std::uint16_t kPointSizes[kPointFormats] = {20, 28, 26, 34, 57, 63,
                                                             30, 36, 38, 59, 67};

/// Formats 6 and up have more returns and classes.
inline constexpr int kFirstLongFormat = 6;

/// Where of each kind of format.
struct ShortPoint {
  static constexpr int kReturns = 14, kClass = 15, kUserData = 17;
};
struct LongPoint {
  static constexpr int kReturns = 14, kFlags = 15, kClass = 16;
  static constexpr std::size_t kSize = 30;
};

/// Formats 0 to 5: three bits each for the return's number and the number of returns; three flags
/// above the class, of which the highest means withheld.
inline void set_returns(RawPoint& point, unsigned number, unsigned count) {
  point.first_return = number <= 1;
  point.last_return = number == count;
}
inline void set_short_returns(RawPoint& point, std::uint8_t byte) {
  set_returns(point, byte & 7u, byte >> 3 & 7u);
}
inline void set_short_class(RawPoint& point, std::uint8_t byte) {
  point.point_class = byte & 31u;
  point.withheld = (byte & 128u) != 0;
}
inline bool is_withheld_flag(unsigned long_flags) {
  return (long_flags & 4u) != 0;
}

inline RawPoint raw_point(const char* from, bool is_long) {
  RawPoint point{};
  point.x = number_at<std::int32_t>(from);
  point.y = number_at<std::int32_t>(from + 4);
  point.z = number_at<std::int32_t>(from + 8);
  const auto byte = [&](int i) { return static_cast<std::uint8_t>(from[i]); };
  if (is_long) {
    const std::uint8_t returns = byte(LongPoint::kReturns);
    set_returns(point, returns & 15u, returns >> 4);
    point.point_class = byte(LongPoint::kClass);
    point.withheld = is_withheld_flag(byte(LongPoint::kFlags));
  } else {
    set_short_returns(point, byte(ShortPoint::kReturns));
    set_short_class(point, byte(ShortPoint::kClass));
  }
  return point;
}

}  // namespace hodt::las
