// Sums of doubles without rounding.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace hodt {

/// A sum of doubles, kept exactly and rounded only where it is read: it does not depend on the
/// order of its terms, and what is rounded compares as the sums do. With a term that is infinite or
/// undefined so is the sum.
class ExactSum {
 public:
  void add(double value);
  /// Adds all of them; mostly as fast as an ordinary sum.
  void add(std::span<const double> values);
  void add(const ExactSum& other);
  void subtract(double value) { add(-value); }
  void subtract(const ExactSum& other);

  /// Whether nothing was added but zeros; false also for a few other sums that are 0.
  bool is_empty() const;
  /// The nearest double, of two the one with an even last bit; infinite out of a double's range.
  double nearest() const;
  /// The largest double that is no more, and the smallest that is no less.
  double down() const;
  double up() const;

 private:
  // The sum is that of digit[i] * 2^(32 i - 1074). A double touches three digits by less than 2^32
  // each; the highest ones are for what 2^62 terms carry.
  static constexpr int kDigits = 68;
  static constexpr std::int64_t kBase = std::int64_t{1} << 32;
  static constexpr int kMostTerms = 1 << 29;  // before a digit could overflow

  void carry();
  struct Rounded;
  Rounded rounded() const;

  std::array<std::int64_t, kDigits> digit_{};
  double not_finite_ = 0;  // or infinite, or undefined
  int terms_ = 0;          // since digits were last carried
};

}  // namespace hodt
