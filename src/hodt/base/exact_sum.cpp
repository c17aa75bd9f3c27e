#include "hodt/base/exact_sum.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "hodt/base/lanes.h"

namespace hodt {

void ExactSum::add(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const int field = static_cast<int>(bits >> 52 & 0x7ff);
  if (field == 0x7ff) {
    not_finite_ += value;
    return;
  }
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  const std::uint64_t mantissa = field == 0 ? fraction : fraction | std::uint64_t{1} << 52;
  const int shift = std::max(field, 1) - 1;
  const auto i = static_cast<std::size_t>(shift / 32);
  const std::uint64_t low = (mantissa & 0xffff'ffff) << shift % 32;
  const std::uint64_t high = (mantissa >> 32) << shift % 32;
  const std::int64_t sign = value < 0 ? -1 : 1;
  digit_[i] += sign * static_cast<std::int64_t>(low & 0xffff'ffff);
  digit_[i + 1] += sign * static_cast<std::int64_t>((low >> 32) + (high & 0xffff'ffff));
  digit_[i + 2] += sign * static_cast<std::int64_t>(high >> 32);
  if (++terms_ >= kMostTerms) carry();
}

namespace {

/// Values added up in two parts that need no rounding: multiples of 2^-44 of the largest, and of
/// 2^-88. Adding a number far larger than a value, and taking it away again, rounds the value to a
/// multiple of that number's last place.
class Parts {
 public:
  static constexpr std::size_t kMostValues = 256;

  HODT_INLINE explicit Parts(std::span<const double> values) {
    Sums most{};
    const std::size_t even = values.size() - values.size() % kSums;
    for (std::size_t i = 0; i < even; i += kSums)
      for (std::size_t j = 0; j < kSums; ++j) {
        const double size = std::fabs(values[i + j]);
        most[j] = size > most[j] ? size : most[j];
      }
    for (std::size_t i = even; i < values.size(); ++i)
      most[0] = std::max(most[0], std::fabs(values[i]));
    for (const double m : most) largest = m > largest ? m : largest;
    const double scale = power_of_two_above(largest), high = 0x1.8p8 * scale, low = 0x1p-44 * high;
    Sums high_sums{}, low_sums{}, rests{};
    const auto add = [&](double value, std::size_t j) HODT_INLINE_LAMBDA {
      const double part = (high + value) - high, rest = value - part;
      const double low_part = (low + rest) - low;
      high_sums[j] += part;
      low_sums[j] += low_part;
      rests[j] += std::fabs(rest - low_part);
    };
    for (std::size_t i = 0; i < even; i += kSums)
      for (std::size_t j = 0; j < kSums; ++j) add(values[i + j], j);
    for (std::size_t i = even; i < values.size(); ++i) add(values[i], 0);
    double left = 0;
    for (std::size_t j = 0; j < kSums; ++j) {
      high_sum += high_sums[j];
      low_sum += low_sums[j];
      left += rests[j];
    }
    is_all = left == 0 && largest < 0x1p1000 && largest > 0x1p-900;  // or parts are out of range
  }

  double largest = 0, high_sum = 0, low_sum = 0;
  bool is_all = false;  // nothing is left over

 private:
  // Side by side, as each sum has to wait for itself.
  static constexpr std::size_t kSums = 16;
  using Sums = std::array<double, kSums>;

  static double power_of_two_above(double value) {
    const std::uint64_t exponent = std::bit_cast<std::uint64_t>(value) >> 52;
    return std::bit_cast<double>((exponent + 1) << 52);
  }
};

}  // namespace

void ExactSum::add(std::span<const double> values) {
  while (!values.empty()) {
    const auto piece = values.first(std::min(values.size(), Parts::kMostValues));
    values = values.subspan(piece.size());
    double high = 0, low = 0;
    const bool is_all = run_in_lanes([&]<Index>() HODT_INLINE_LAMBDA {
      const Parts parts(piece);
      high = parts.high_sum;
      low = parts.low_sum;
      return parts.is_all;
    });
    if (is_all) {
      add(high);
      add(low);
    } else {
      for (const double value : piece) add(value);
    }
  }
}

void ExactSum::add(const ExactSum& other) {
  for (std::size_t i = 0; i < kDigits; ++i) digit_[i] += other.digit_[i];
  not_finite_ += other.not_finite_;
  terms_ += other.terms_ + 1;
  if (terms_ >= kMostTerms) carry();
}

void ExactSum::subtract(const ExactSum& other) {
  for (std::size_t i = 0; i < kDigits; ++i) digit_[i] -= other.digit_[i];
  not_finite_ -= other.not_finite_;
  terms_ += other.terms_ + 1;
  if (terms_ >= kMostTerms) carry();
}

bool ExactSum::is_empty() const {
  return not_finite_ == 0 &&
         std::all_of(digit_.begin(), digit_.end(), [](auto d) { return d == 0; });
}

/// All digits but the highest one are in [0, 2^32) then.
void ExactSum::carry() {
  for (std::size_t i = 0; i + 1 < kDigits; ++i) {
    const std::int64_t over = digit_[i] >> 32;  // rounds down
    digit_[i] -= over * kBase;
    digit_[i + 1] += over;
  }
  terms_ = 1;
}

/// The sum's magnitude between two neighbouring doubles.
struct ExactSum::Rounded {
  double toward_zero;
  bool is_exact;
  bool is_away_nearer;
  bool is_negative;

  double away() const {
    return is_exact ? toward_zero
                    : std::nextafter(toward_zero, std::numeric_limits<double>::infinity());
  }
  double with_sign(double magnitude) const { return is_negative ? -magnitude : magnitude; }
};

ExactSum::Rounded ExactSum::rounded() const {
  if (not_finite_ != 0) return {not_finite_, true, false, false};
  ExactSum sum = *this;
  sum.carry();
  const bool is_negative = sum.digit_[kDigits - 1] < 0;
  if (is_negative) {
    for (std::int64_t& digit : sum.digit_) digit = -digit;
    sum.carry();
  }
  const auto bit = [&](int at) {
    return at >= 0 && (sum.digit_[std::size_t(at / 32)] >> at % 32 & 1) != 0;
  };
  int top = kDigits - 1;
  while (top > 0 && sum.digit_[std::size_t(top)] == 0) --top;
  if (sum.digit_[std::size_t(top)] == 0) return {0, true, false, false};
  const int first =
      32 * top +
      static_cast<int>(std::bit_width(static_cast<std::uint64_t>(sum.digit_[std::size_t(top)]))) -
      1;
  constexpr int kBits = std::numeric_limits<double>::digits;
  const int last = std::max(first - kBits + 1, 0);
  std::uint64_t mantissa = 0;
  for (int at = first; at >= last; --at) mantissa = 2 * mantissa + std::uint64_t{bit(at)};
  bool is_more_below = false;  // the first bit that is left out
  for (int at = last - 2; at >= 0 && !is_more_below; --at) is_more_below = bit(at);
  const bool is_half = bit(last - 1);
  const bool is_odd = (mantissa & 1) != 0;
  const int exponent = last + std::numeric_limits<double>::min_exponent - kBits;
  if (first + std::numeric_limits<double>::min_exponent - kBits >=
      std::numeric_limits<double>::max_exponent)
    return {std::numeric_limits<double>::max(), false, true, is_negative};
  return {std::ldexp(static_cast<double>(mantissa), exponent), !is_half && !is_more_below,
          is_half && (is_more_below || is_odd), is_negative};
}

double ExactSum::nearest() const {
  const Rounded r = rounded();
  return r.with_sign(r.is_away_nearer ? r.away() : r.toward_zero);
}

double ExactSum::down() const {
  const Rounded r = rounded();
  return r.with_sign(r.is_negative ? r.away() : r.toward_zero);
}

double ExactSum::up() const {
  const Rounded r = rounded();
  return r.with_sign(r.is_negative ? r.toward_zero : r.away());
}

}  // namespace hodt
