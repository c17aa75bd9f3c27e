// Times are not needed, but how the difference of the last two was decides what comes next.
// Tested by tests/io/las_test.cpp.

#include <cstdint>
#include <memory>

#include "hodt/io/las/pointwise_items.h"

namespace hodt::las {

namespace {

std::int32_t times(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) * static_cast<std::uint32_t>(b));
}

/// The last difference of times. One that often is not of its size is replaced by a new one.
struct Step {
  std::int32_t size = 0;
  int misses = 0;

  void become(std::int32_t other) { *this = {other, 0}; }
  void miss(std::int32_t other) {
    constexpr int patience = 3;
    if (++misses > patience) become(other);
  }
};

class GpsTimeV1 final : public PointwiseItem {
 public:
  void start(const char*) override {
    step_ = {};
    is_multiple_.start(kFull + 2);
    is_new_.start(3);
    steps_.forget();
  }

  void next(ArithmeticDecoder& in) override {
    if (step_.size == 0) {
      const std::uint32_t kind = in.symbol(is_new_);
      if (kind == 1) step_.size = steps_.next(in, 0, 0);
      if (kind == 2) go_past_time(in);
      return;
    }
    const std::uint32_t multiple = in.symbol(is_multiple_);
    if (multiple == kFull) go_past_time(in);
    if (multiple >= kFull) return;
    if (multiple == 1) {
      step_.become(steps_.next(in, step_.size, 1));
    } else if (multiple == 0) {
      step_.miss(steps_.next(in, step_.size / 4, 2));
    } else {
      const std::uint32_t context = multiple < 10 ? 3 : multiple < 50 ? 4 : 5;
      const std::int32_t found =
          steps_.next(in, times(step_.size, static_cast<std::int32_t>(multiple)), context);
      if (multiple == kFull - 1) step_.miss(found);
    }
  }

 private:
  static constexpr std::uint32_t kFull = 510;  ///< a whole time follows; above, the same time again

  static void go_past_time(ArithmeticDecoder& in) {
    in.bits(32);
    in.bits(32);
  }

  Step step_;
  SymbolModel<kFull + 2> is_multiple_;
  SymbolModel<3> is_new_;
  IntegerDecoder<32, 6> steps_;
};

/// Up to four sequences of times go side by side.
class GpsTimeV2 final : public PointwiseItem {
 public:
  void start(const char*) override {
    for (Step& step : steps_) step = {};
    now_ = newest_ = 0;
    is_multiple_.start(kFull + 4);
    is_new_.start(6);
    sizes_.forget();
  }

  void next(ArithmeticDecoder& in) override {
    // Each turn takes a symbol of which the data hold only so many.
    while (!is_found(in)) continue;
  }

 private:
  static constexpr std::int32_t kMost = 500, kLeast = -10;
  static constexpr std::uint32_t kSame = kMost - kLeast + 1;
  static constexpr std::uint32_t kFull = kSame + 1;

  /// False if the time belongs to the sequence that is now chosen.
  bool is_found(ArithmeticDecoder& in) {
    if (steps_[now_].size == 0) {
      const std::uint32_t kind = in.symbol(is_new_);
      if (kind == 1) steps_[now_].become(sizes_.next(in, 0, 0));
      if (kind == 2) begin_sequence(in);
      if (kind > 2) now_ = (now_ + kind - 2) % 4;
      return kind <= 2;
    }
    const std::uint32_t code = in.symbol(is_multiple_);
    if (code < kSame) next_step(in, static_cast<std::int32_t>(code));
    if (code == kFull) begin_sequence(in);
    if (code > kFull) now_ = (now_ + code - kFull) % 4;
    return code <= kFull;
  }

  void next_step(ArithmeticDecoder& in, std::int32_t code) {
    Step& step = steps_[now_];
    if (code == 1) {
      sizes_.correction(in, 1);
      step.misses = 0;
    } else if (code == 0) {
      step.miss(sizes_.next(in, 0, 7));
    } else if (code < kMost) {
      sizes_.correction(in, code < 10 ? 2 : 3);
    } else if (code == kMost) {
      step.miss(sizes_.next(in, times(step.size, kMost), 4));
    } else if (kMost - code > kLeast) {
      sizes_.correction(in, 5);
    } else {
      step.miss(sizes_.next(in, times(step.size, kLeast), 6));
    }
  }

  void begin_sequence(ArithmeticDecoder& in) {
    sizes_.correction(in, 8);
    in.bits(32);
    newest_ = (newest_ + 1) % 4;
    now_ = newest_;
    steps_[now_] = {};
  }

  Step steps_[4];
  std::uint32_t now_ = 0, newest_ = 0;
  SymbolModel<kFull + 4> is_multiple_;
  SymbolModel<6> is_new_;
  IntegerDecoder<32, 9> sizes_;
};

}  // namespace

std::unique_ptr<PointwiseItem> make_gps_time(int version) {
  if (version == 1) return std::make_unique<GpsTimeV1>();
  return std::make_unique<GpsTimeV2>();
}

}  // namespace hodt::las
