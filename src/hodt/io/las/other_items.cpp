// Colours, wave packets and extra bytes: nothing of their values is needed to go past them.
// Tested by tests/io/las_test.cpp.

#include <cstddef>
#include <memory>
#include <vector>

#include "hodt/io/las/pointwise_items.h"

namespace hodt::las {

namespace {

/// Six bytes, low and high of red, green and blue; a symbol says which of them change.
class RgbV1 final : public PointwiseItem {
 public:
  void start(const char*) override {
    changed_.start(64);
    bytes_.forget();
  }
  void next(ArithmeticDecoder& in) override {
    const std::uint32_t changed = in.symbol(changed_);
    for (std::uint32_t i = 0; i < 6; ++i)
      if (changed >> i & 1u) bytes_.correction(in, i);
  }

 private:
  SymbolModel<64> changed_;
  IntegerDecoder<8, 6> bytes_;
};

class RgbV2 final : public PointwiseItem {
 public:
  void start(const char*) override {
    changed_.start(128);
    bytes_.forget();
  }
  void next(ArithmeticDecoder& in) override {
    const std::uint32_t changed = in.symbol(changed_);
    const auto go_past = [&](std::uint32_t i) {
      if (changed >> i & 1u) in.symbol(bytes_[i]);
    };
    go_past(0);
    go_past(1);
    // A grey is told by its red alone.
    if (changed >> 6 == 0) return;
    for (const std::uint32_t i : {2u, 4u, 3u, 5u}) go_past(i);
  }

 private:
  SymbolModel<128> changed_;
  SymbolModels<256, 6> bytes_;
};

class WavePacket final : public PointwiseItem {
 public:
  void start(const char*) override {
    index_.start(256);
    for (SymbolModel<4>& model : offset_kind_) model.start(4);
    last_kind_ = 0;
    offset_.forget();
    size_.forget();
    return_point_.forget();
    direction_.forget();
  }
  void next(ArithmeticDecoder& in) override {
    in.symbol(index_);
    last_kind_ = in.symbol(offset_kind_[last_kind_]);
    if (last_kind_ == 2) offset_.correction(in, 0);
    if (last_kind_ == 3) {
      in.bits(32);
      in.bits(32);
    }
    size_.correction(in, 0);
    return_point_.correction(in, 0);
    for (std::uint32_t axis = 0; axis < 3; ++axis) direction_.correction(in, axis);
  }

 private:
  SymbolModel<256> index_;
  SymbolModel<4> offset_kind_[4];
  std::uint32_t last_kind_ = 0;
  IntegerDecoder<32, 1> offset_, size_, return_point_;
  IntegerDecoder<32, 3> direction_;
};

class ExtraBytes final : public PointwiseItem {
 public:
  explicit ExtraBytes(std::size_t count) : models_(count) {}
  void start(const char*) override {
    for (SymbolModel<256>& model : models_) model.start(256);
  }
  void next(ArithmeticDecoder& in) override {
    for (SymbolModel<256>& model : models_) in.symbol(model);
  }

 private:
  std::vector<SymbolModel<256>> models_;
};

}  // namespace

std::unique_ptr<PointwiseItem> make_rgb(int version) {
  if (version == 1) return std::make_unique<RgbV1>();
  return std::make_unique<RgbV2>();
}

std::unique_ptr<PointwiseItem> make_wave_packet() {
  return std::make_unique<WavePacket>();
}

std::unique_ptr<PointwiseItem> make_extra_bytes(std::size_t count) {
  return std::make_unique<ExtraBytes>(count);
}

}  // namespace hodt::las
