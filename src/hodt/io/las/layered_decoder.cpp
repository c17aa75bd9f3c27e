// Points of formats 6 to 10, as LASzip 3 compresses them: a chunk has a layer for each kind of
// value, which is a stream of its own. Layers that are not needed are not decoded, and a layer of
// no bytes means that the first point's value is that of all.
// Tested by tests/io/las_test.cpp.

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include <fmt/format.h>

#include "hodt/io/las/chunk_decoder.h"
#include "hodt/io/las/chunk_end.h"
#include "hodt/io/las/integer_decoder.h"
#include "hodt/io/las/moving_median.h"
#include "hodt/io/las/return_contexts.h"

namespace hodt::las {

namespace {

/// A point as it predicts the next one.
struct LongRawPoint {
  std::int32_t x = 0, y = 0, z = 0;
  std::uint8_t number = 0, count = 0;  ///< the return's, and of returns
  std::uint8_t point_class = 0;
  std::uint8_t flags = 0;  ///< four of the class, the scan direction, the edge of the flight line
  bool has_new_time = false;

  explicit LongRawPoint(const char* from)
      : x(number_at<std::int32_t>(from)),
        y(number_at<std::int32_t>(from + 4)),
        z(number_at<std::int32_t>(from + 8)) {
    const auto byte = [&](int i) { return static_cast<unsigned char>(from[i]); };
    number = byte(LongPoint::kReturns) & 15u;
    count = byte(LongPoint::kReturns) >> 4;
    point_class = byte(LongPoint::kClass);
    const unsigned bits = byte(LongPoint::kFlags);
    flags = static_cast<std::uint8_t>((bits & 15u) | (bits >> 6) << 4);
  }
  LongRawPoint() = default;

  RawPoint raw() const {
    RawPoint point{};
    point.x = x;
    point.y = y;
    point.z = z;
    point.point_class = point_class;
    point.withheld = is_withheld_flag(flags);
    set_returns(point, number, count);
    return point;
  }
};

constexpr unsigned kChannels = 4;

unsigned channel_of(const char* first) {
  return static_cast<unsigned char>(first[LongPoint::kFlags]) >> 4 & 3u;
}

/// What is known of one scanner channel: points of the same channel predict each other.
class Channel {
 public:
  bool is_used() const { return is_used_; }
  const LongRawPoint& last() const { return last_; }
  void forget() { is_used_ = false; }

  void start(const LongRawPoint& first) {
    is_used_ = true;
    last_ = first;
    last_.has_new_time = false;
    std::fill(std::begin(last_z_), std::end(last_z_), first.z);
    for (auto* const medians : {&dx_median_, &dy_median_})
      std::fill(std::begin(*medians), std::end(*medians), MovingMedian());
    channel_step_.start(3);
    number_step_.start(13);
    changed_.forget();
    counts_.forget();
    numbers_.forget();
    classes_.forget();
    flags_.forget();
    dx_.forget();
    dy_.forget();
    z_.forget();
  }

  /// What changes from this channel's last point to the next point, which may be another's.
  std::uint32_t next_change(ArithmeticDecoder& in) {
    const unsigned first = last_.number == 1 ? 1 : 0;
    const unsigned final = last_.number >= last_.count ? 2 : 0;
    return in.symbol(changed_[first + final + (last_.has_new_time ? 4 : 0)]);
  }
  std::uint32_t next_channel_step(ArithmeticDecoder& in) { return in.symbol(channel_step_) + 1; }

  /// The returns, x and y.
  void next_place(ArithmeticDecoder& in, std::uint32_t changed) {
    last_.has_new_time = (changed & 16u) != 0;
    if (changed & 4u) last_.count = static_cast<std::uint8_t>(in.symbol(counts_[last_.count]));
    next_number(in, changed & 3u);
    single_ = last_.count == 1 ? 1 : 0;
    const std::size_t context =
        2 * kLongReturnContext[last_.count][last_.number] + (last_.has_new_time ? 1 : 0);
    move(last_.x, dx_.next(in, dx_median_[context].get(), single_), dx_median_[context]);
    const std::uint32_t dy_context = single_ + size_context(dx_.last_bits(), 20);
    move(last_.y, dy_.next(in, dy_median_[context].get(), dy_context), dy_median_[context]);
  }
  void next_z(ArithmeticDecoder& in) {
    std::int32_t& height = last_z_[height_context(last_.count, last_.number)];
    const std::uint32_t bits = (dx_.last_bits() + dy_.last_bits()) / 2;
    height = last_.z = z_.next(in, height, single_ + size_context(bits, 18));
  }
  void next_class(ArithmeticDecoder& in) {
    const bool is_only = last_.number == 1 && last_.number >= last_.count;
    const std::size_t context = 2 * (last_.point_class & 31u) + (is_only ? 1 : 0);
    last_.point_class = static_cast<std::uint8_t>(in.symbol(classes_[context]));
  }
  void next_flags(ArithmeticDecoder& in) {
    last_.flags = static_cast<std::uint8_t>(in.symbol(flags_[last_.flags]));
  }

 private:
  void next_number(ArithmeticDecoder& in, std::uint32_t how) {
    unsigned number = last_.number;
    if (how == 1) number += 1;
    if (how == 2) number += 15;
    if (how == 3)
      number =
          last_.has_new_time ? in.symbol(numbers_[number]) : number + in.symbol(number_step_) + 2;
    last_.number = static_cast<std::uint8_t>(number % 16);
  }

  static void move(std::int32_t& coordinate, std::int32_t by, MovingMedian& median) {
    median.add(by);
    coordinate = wrapped_sum(coordinate, by);
  }

  bool is_used_ = false;
  LongRawPoint last_;
  std::uint32_t single_ = 0;
  MovingMedian dx_median_[12], dy_median_[12];
  std::int32_t last_z_[8] = {};

  SymbolModel<3> channel_step_;
  SymbolModel<13> number_step_;
  SymbolModels<128, 8> changed_;
  SymbolModels<16, 16> counts_, numbers_;
  SymbolModels<256, 64> classes_;
  SymbolModels<64, 64> flags_;
  IntegerDecoder<32, 2> dx_;
  IntegerDecoder<32, 22> dy_;
  IntegerDecoder<32, 20> z_;
};

class LayeredDecoder final : public ChunkDecoder {
 public:
  explicit LayeredDecoder(const LazLayout& layout) : point_size_(layout.point_size) {
    for (const LazItem& item : layout.items) layers_ += layers_of(item);
  }

  void decode(const Chunk& chunk, std::vector<RawPoint>& points) override {
    const LongRawPoint first(chunk.begin);
    points.push_back(first.raw());
    open_layers(chunk);
    if (chunk.points == 1) return;
    for (Channel& channel : channels_) channel.forget();
    unsigned now = channel_of(chunk.begin);
    channels_[now].start(first);
    for (std::size_t i = 1; i < chunk.points; ++i) {
      now = next(now);
      points.push_back(channels_[now].last().raw());
    }
    for (const Layer& layer : needed_)
      if (layer.is_there) check_end(layer.in);
  }

 private:
  enum { kPlace, kZ, kClass, kFlags, kNeeded };

  struct Layer {
    bool is_there = false;
    ArithmeticDecoder in;
  };

  static std::size_t layers_of(const LazItem& item) {
    constexpr std::size_t of_point = 9, of_rgb_nir = 2;
    if (item.kind == LazItemKind::point14) return of_point;
    if (item.kind == LazItemKind::rgb_nir14) return of_rgb_nir;
    if (item.kind == LazItemKind::bytes14) return item.size;
    return 1;
  }

  /// Behind the first point stand the number of points and the sizes of all layers.
  void open_layers(const Chunk& chunk) {
    const auto left = [&](const char* from) { return static_cast<std::size_t>(chunk.end - from); };
    const char* from = chunk.begin + point_size_;
    const std::size_t header = 4 * (1 + layers_);
    if (left(from) < header) throw Damage{"it ends before its layers begin"};
    const auto count = number_at<std::uint32_t>(from);
    if (count != chunk.points)
      throw Damage{fmt::format("it says that it has {} points, and the table of chunks says {}",
                               count, chunk.points)};
    const char* const sizes = from + 4;
    from += header;
    for (std::size_t i = 0; i < layers_; ++i) {
      const std::size_t size = number_at<std::uint32_t>(sizes + 4 * i);
      if (size > left(from)) throw Damage{fmt::format("its layer {} does not fit into it", i + 1)};
      if (i < kNeeded) {
        needed_[i].is_there = size > 0;
        if (size > 0 && chunk.points > 1) needed_[i].in = ArithmeticDecoder(from, from + size);
      }
      from += size;
    }
    if (from != chunk.end) throw Damage{fmt::format("{} of its bytes are in no layer", left(from))};
    if (chunk.points > 1 && !needed_[kPlace].is_there) throw Damage{"its first layer is empty"};
  }

  /// Decodes a point; returns its channel.
  unsigned next(unsigned now) {
    ArithmeticDecoder& in = needed_[kPlace].in;
    const std::uint32_t changed = channels_[now].next_change(in);
    if (changed & 64u) {
      const unsigned other = (now + channels_[now].next_channel_step(in)) % kChannels;
      if (!channels_[other].is_used()) channels_[other].start(channels_[now].last());
      now = other;
    }
    Channel& channel = channels_[now];
    channel.next_place(in, changed);
    if (needed_[kZ].is_there) channel.next_z(needed_[kZ].in);
    if (needed_[kClass].is_there) channel.next_class(needed_[kClass].in);
    if (needed_[kFlags].is_there) channel.next_flags(needed_[kFlags].in);
    return now;
  }

  std::size_t point_size_;
  std::size_t layers_ = 0;
  Layer needed_[kNeeded];
  Channel channels_[kChannels];
};

}  // namespace

std::unique_ptr<ChunkDecoder> make_layered_decoder(const LazLayout& layout) {
  return std::make_unique<LayeredDecoder>(layout);
}

}  // namespace hodt::las
