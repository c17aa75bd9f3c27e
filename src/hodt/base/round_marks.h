// Marks that are all taken off at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "hodt/base/buffer.h"
#include "hodt/base/ids.h"

namespace hodt {

/// Marks on the numbers below `count`: each holds the round in which it was marked last, so that a
/// new round takes all marks off. Memory is taken in the first round.
class RoundMarks {
 public:
  using Round = std::uint32_t;

  explicit RoundMarks(std::size_t count) : count_(count) {}

  /// Takes all marks off. REQUIRED before the first mark.
  void begin_round() {
    constexpr Round kLast = std::numeric_limits<Round>::max();
    if (marks_.empty() || round_ == kLast) {
      marks_ = Buffer<Round>(count_, 0);
      round_ = 0;
    }
    ++round_;
  }
  /// False if i was marked already.
  bool mark(Index i) {
    if (marks_[i] == round_) return false;
    marks_[i] = round_;
    return true;
  }

  bool is_marked(Index i) const { return marks_[i] == round_; }

  /// For loops that keep them in registers: i is marked if marks()[i] == round().
  Round* marks() { return marks_.data(); }
  Round round() const { return round_; }

 private:
  std::size_t count_;
  Buffer<Round> marks_;
  Round round_ = 0;
};

}  // namespace hodt
