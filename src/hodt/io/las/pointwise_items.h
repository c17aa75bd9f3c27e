// What a point of formats 0 to 5 is made of, as LASzip compresses it point by point (versions 1 and
// 2 of the items POINT10, GPSTIME11, RGB12, WAVEPACKET13 and BYTE).
//
// One stream of symbols holds all items in turn, and a symbol's meaning depends on those before it.
// So every item is decoded, but only as far as later symbols or the point itself need its values:
// colours and times are gone past.
// Tested by tests/io/las_test.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "hodt/io/las/integer_decoder.h"
#include "hodt/io/las/moving_median.h"
#include "hodt/io/las/raw_point.h"

namespace hodt::las {

/// A kind of item. One object serves chunk after chunk.
class PointwiseItem {
 public:
  PointwiseItem() = default;
  PointwiseItem(const PointwiseItem&) = delete;
  PointwiseItem& operator=(const PointwiseItem&) = delete;
  virtual ~PointwiseItem() = default;

  /// Begins a chunk with its first point's bytes of this item, which are not compressed.
  virtual void start(const char* first) = 0;
  virtual void next(ArithmeticDecoder& in) = 0;
};

/// Coordinates, returns and class.
class Point10 : public PointwiseItem {
 public:
  virtual const RawPoint& point() const = 0;
};

/// Their models are large, and written when they are first needed.
std::unique_ptr<Point10> make_point10_v1();
std::unique_ptr<Point10> make_point10_v2();
std::unique_ptr<PointwiseItem> make_gps_time(int version);
std::unique_ptr<PointwiseItem> make_rgb(int version);
std::unique_ptr<PointwiseItem> make_wave_packet();
std::unique_ptr<PointwiseItem> make_extra_bytes(std::size_t count);

}  // namespace hodt::las
