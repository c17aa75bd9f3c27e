// The item POINT10 as LASzip 2 and 3 compress it.
// Tested by tests/io/las_test.cpp.
#include <memory>

#include "hodt/io/las/pointwise_items.h"
#include "hodt/io/las/return_contexts.h"

namespace hodt::las {

namespace {

class Point10V2 final : public Point10 {
 public:
  void start(const char* first) override {
    point_ = raw_point(first, false);
    returns_ = byte_of(first, ShortPoint::kReturns);
    class_ = byte_of(first, ShortPoint::kClass);
    user_data_ = byte_of(first, ShortPoint::kUserData);
    changed_.start(64);
    returns_models_.forget();
    class_models_.forget();
    user_data_models_.forget();
    scan_angle_.forget();
    intensity_.forget();
    source_.forget();
    dx_.forget();
    dy_.forget();
    z_.forget();
    for (int i = 0; i < kReturnContexts; ++i) dx_median_[i] = dy_median_[i] = {};
    for (std::int32_t& height : last_height_) height = 0;
  }

  void next(ArithmeticDecoder& in) override {
    if (const std::uint32_t changed = in.symbol(changed_)) next_attributes(in, changed);
    const unsigned number = returns_ & 7u, count = returns_ >> 3 & 7u;
    const unsigned context = kShortReturnContext[count][number];
    const std::uint32_t single = count == 1 ? 1 : 0;
    point_.x =
        moved(point_.x, dx_.next(in, dx_median_[context].get(), single), dx_median_[context]);
    const std::uint32_t dy_context = single + size_context(dx_.last_bits(), 20);
    point_.y =
        moved(point_.y, dy_.next(in, dy_median_[context].get(), dy_context), dy_median_[context]);
    std::int32_t& height = last_height_[height_context(count, number)];
    const std::uint32_t bits = (dx_.last_bits() + dy_.last_bits()) / 2;
    height = point_.z = z_.next(in, height, single + size_context(bits, 18));
  }

  const RawPoint& point() const override { return point_; }

 private:
  static constexpr int kReturnContexts = 16;

  static std::uint8_t byte_of(const char* point, int i) {
    return static_cast<std::uint8_t>(point[i]);
  }

  static std::int32_t moved(std::int32_t from, std::int32_t by, MovingMedian& median) {
    median.add(by);
    return wrapped_sum(from, by);
  }

  void next_attributes(ArithmeticDecoder& in, std::uint32_t changed) {
    if (changed & 32u) {
      returns_ = static_cast<std::uint8_t>(in.symbol(returns_models_[returns_]));
      set_short_returns(point_, returns_);
    }
    if (changed & 16u) {
      const std::uint32_t context = kShortReturnContext[returns_ >> 3 & 7u][returns_ & 7u];
      intensity_.correction(in, std::min(context, 3u));
    }
    if (changed & 8u) {
      class_ = static_cast<std::uint8_t>(in.symbol(class_models_[class_]));
      set_short_class(point_, class_);
    }
    const std::size_t scan_direction = returns_ >> 6 & 1u;
    if (changed & 4u) in.symbol(scan_angle_[scan_direction]);
    if (changed & 2u)
      user_data_ = static_cast<std::uint8_t>(in.symbol(user_data_models_[user_data_]));
    if (changed & 1u) source_.correction(in, 0);
  }

  RawPoint point_{};
  std::uint8_t returns_ = 0;  ///< with the direction and the edge flag
  std::uint8_t class_ = 0;    ///< with the flags
  std::uint8_t user_data_ = 0;
  MovingMedian dx_median_[kReturnContexts], dy_median_[kReturnContexts];
  std::int32_t last_height_[8] = {};

  SymbolModel<64> changed_;
  SymbolModels<256, 2> scan_angle_;
  IntegerDecoder<32, 2> dx_;
  IntegerDecoder<32, 22> dy_;
  IntegerDecoder<32, 20> z_;
  IntegerDecoder<16, 4> intensity_;
  IntegerDecoder<16, 1> source_;
  SymbolModels<256, 256> returns_models_, class_models_, user_data_models_;
};

}  // namespace

std::unique_ptr<Point10> make_point10_v2() {
  return std::make_unique_for_overwrite<Point10V2>();
}

}  // namespace hodt::las
