// The item POINT10 as LASzip 1 compressed it.
// Tested by tests/io/las_test.cpp.
#include <algorithm>
#include <memory>

#include "hodt/io/las/pointwise_items.h"

namespace hodt::las {

namespace {

/// The middle one of the last three differences.
class LastThree {
 public:
  std::int32_t median() const {
    const auto [a, b, c] = values_;
    return std::max(std::min(a, b), std::min(std::max(a, b), c));
  }
  void add(std::int32_t value, int at) {
    (at == 0 ? values_.a : at == 1 ? values_.b : values_.c) = value;
  }

 private:
  struct {
    std::int32_t a = 0, b = 0, c = 0;
  } values_;
};

class Point10V1 final : public Point10 {
 public:
  void start(const char* first) override {
    point_ = raw_point(first, false);
    returns_ = static_cast<std::uint8_t>(first[ShortPoint::kReturns]);
    class_ = static_cast<std::uint8_t>(first[ShortPoint::kClass]);
    user_data_ = static_cast<std::uint8_t>(first[ShortPoint::kUserData]);
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
    x_steps_ = y_steps_ = {};
    oldest_ = 0;
  }

  void next(ArithmeticDecoder& in) override {
    const std::int32_t dx = dx_.next(in, x_steps_.median(), 0);
    const std::int32_t dy = dy_.next(in, y_steps_.median(), std::min(dx_.last_bits(), kMost));
    const std::uint32_t bits = (dx_.last_bits() + dy_.last_bits()) / 2;
    point_.x = wrapped_sum(point_.x, dx);
    point_.y = wrapped_sum(point_.y, dy);
    point_.z = z_.next(in, point_.z, std::min(bits, kMost));
    if (const std::uint32_t changed = in.symbol(changed_)) next_attributes(in, changed, bits);
    x_steps_.add(dx, oldest_);
    y_steps_.add(dy, oldest_);
    oldest_ = (oldest_ + 1) % 3;
  }

  const RawPoint& point() const override { return point_; }

 private:
  static constexpr std::uint32_t kMost = 19;

  void next_attributes(ArithmeticDecoder& in, std::uint32_t changed, std::uint32_t bits) {
    if (changed & 32u) intensity_.correction(in, 0);
    if (changed & 16u) {
      returns_ = static_cast<std::uint8_t>(in.symbol(returns_models_[returns_]));
      set_short_returns(point_, returns_);
    }
    if (changed & 8u) {
      class_ = static_cast<std::uint8_t>(in.symbol(class_models_[class_]));
      set_short_class(point_, class_);
    }
    if (changed & 4u) scan_angle_.correction(in, bits < 3 ? 1 : 0);
    if (changed & 2u)
      user_data_ = static_cast<std::uint8_t>(in.symbol(user_data_models_[user_data_]));
    if (changed & 1u) source_.correction(in, 0);
  }

  RawPoint point_{};
  std::uint8_t returns_ = 0, class_ = 0, user_data_ = 0;
  LastThree x_steps_, y_steps_;
  int oldest_ = 0;

  SymbolModel<64> changed_;
  IntegerDecoder<32, 1> dx_;
  IntegerDecoder<32, 20> dy_, z_;
  IntegerDecoder<16, 1> intensity_, source_;
  IntegerDecoder<8, 2> scan_angle_;
  SymbolModels<256, 256> returns_models_, class_models_, user_data_models_;
};

}  // namespace

std::unique_ptr<Point10> make_point10_v1() {
  return std::make_unique_for_overwrite<Point10V1>();
}

}  // namespace hodt::las
