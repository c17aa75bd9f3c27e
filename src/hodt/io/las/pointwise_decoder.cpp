// A chunk of points one after the other: the first as it is, then all items of each in one stream.
// Tested by tests/io/las_test.cpp.
#include <utility>

#include "hodt/io/las/chunk_decoder.h"
#include "hodt/io/las/chunk_end.h"
#include "hodt/io/las/pointwise_items.h"

namespace hodt::las {

namespace {

class PointwiseDecoder final : public ChunkDecoder {
 public:
  explicit PointwiseDecoder(const LazLayout& layout) : point_size_(layout.point_size) {
    std::size_t at = 0;
    for (const LazItem& item : layout.items) {
      add(item, at);
      at += item.size;
    }
  }

  void decode(const Chunk& chunk, std::vector<RawPoint>& points) override {
    point10_->start(chunk.begin);
    for (const auto& [item, at] : others_) item->start(chunk.begin + at);
    points.push_back(point10_->point());
    if (chunk.points == 1) return;
    ArithmeticDecoder in(chunk.begin + point_size_, chunk.end);
    for (std::size_t i = 1; i < chunk.points; ++i) {
      point10_->next(in);
      for (const auto& [item, at] : others_) item->next(in);
      points.push_back(point10_->point());
    }
    check_end(in);
  }

 private:
  void add(const LazItem& item, std::size_t at) {
    switch (item.kind) {
      case LazItemKind::point10:
        point10_ = item.version == 1 ? make_point10_v1() : make_point10_v2();
        break;
      case LazItemKind::gps_time11:
        others_.emplace_back(make_gps_time(item.version), at);
        break;
      case LazItemKind::rgb12:
        others_.emplace_back(make_rgb(item.version), at);
        break;
      case LazItemKind::wave_packet13:
        others_.emplace_back(make_wave_packet(), at);
        break;
      default:
        others_.emplace_back(make_extra_bytes(item.size), at);
    }
  }

  std::size_t point_size_;
  std::unique_ptr<Point10> point10_;
  std::vector<std::pair<std::unique_ptr<PointwiseItem>, std::size_t>> others_;
};

}  // namespace

std::unique_ptr<ChunkDecoder> make_pointwise_decoder(const LazLayout& layout) {
  return std::make_unique<PointwiseDecoder>(layout);
}

}  // namespace hodt::las
