#include "hodt/order/slots.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

// One loop for several instruction sets; the processor at hand picks. Fused multiply-add stays out
// (see -ffp-contract), so that all of them round alike.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define HODT_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define HODT_CLONES
#endif

namespace hodt {

namespace {

// The values below are off by less than 12 rounding units of their largest terms, as
// predicate_stages.h shows for CircleFilter; 32 leave room for the sums with the bound itself.
constexpr double kSlack = 32 * 0x1p-53;
constexpr double kTiny = 0x1p-500;  // against underflow, as there
// No overflow: x, y < 2^250, so r < 2^501, times coefficients < 2^500.
constexpr double kMaxCoordinate = 0x1p+250;
constexpr double kMaxCoefficient = 0x1p+500;

constexpr std::array<std::uint64_t, 64> kBits = [] {
  std::array<std::uint64_t, 64> bits{};
  for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = std::uint64_t{1} << i;
  return bits;
}();

/// Of up to 64 slots those with q_r r + q_x x + q_y y + constant < 0.
HODT_CLONES std::uint64_t negative_word(const double* x, const double* y, const double* r,
                                        Index count, double q_r, double q_x, double q_y,
                                        double constant) {
  std::uint64_t mask = 0;
  for (Index i = 0; i < count; ++i) {
    const double value = q_r * r[i] + (q_x * x[i] + q_y * y[i]) + constant;
    mask |= value < 0 ? kBits[i] : 0;
  }
  return mask;
}

}  // namespace

template <int kWords>
void Slots<kWords>::add(double x, double y) {
  const bool usable = std::fabs(x) < kMaxCoordinate && std::fabs(y) < kMaxCoordinate;
  const Index i = size_++;
  if (i % kBlock == 0)
    for (Index j = i; j < i + kBlock; ++j) x_[j] = y_[j] = r_[j] = 0;  // no question selects u
  if (!usable) return;
  x_[i] = x;
  y_[i] = y;
  r_[i] = x * x + y * y;
}

template <int kWords>
SlotMask<kWords> Slots<kWords>::inside_circle(double bx, double by, double cx, double cy) const {
  const double bb = bx * bx + by * by, cc = cx * cx + cy * cy;
  const double q_r = bx * cy - by * cx + kSlack * ((bb + kTiny) + (cc + kTiny));
  const double q_x = by * cc - bb * cy, q_y = bb * cx - bx * cc;
  const double constant = kSlack * ((bb + kTiny) * (cc + kTiny));
  const double largest = std::max({std::fabs(q_r), std::fabs(q_x), std::fabs(q_y), constant});
  if (!(largest < kMaxCoefficient && q_r == q_r)) return {};
  return negative(q_r, q_x, q_y, constant);
}

template <int kWords>
typename Slots<kWords>::Sides Slots<kWords>::sides_of_ray(double x, double y) const {
  if (!(std::fabs(x) < kMaxCoordinate && std::fabs(y) < kMaxCoordinate)) return {};
  const double constant = kSlack * (x * x + y * y) + DBL_MIN;
  return {.left = negative(kSlack, y, -x, constant), .right = negative(kSlack, -y, x, constant)};
}

template <int kWords>
SlotMask<kWords> Slots<kWords>::negative(double q_r, double q_x, double q_y,
                                         double constant) const {
  Mask mask;
  for (Index first = 0; first < size_; first += 64) {
    const Index count = std::min<Index>(64, (size_ - first + kBlock - 1) / kBlock * kBlock);
    mask.words[first / 64] =
        negative_word(&x_[first], &y_[first], &r_[first], count, q_r, q_x, q_y, constant);
  }
  return mask;
}

template class Slots<1>;
template class Slots<4>;
template class Slots<16>;

}  // namespace hodt
