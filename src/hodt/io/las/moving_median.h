// The median that predicts the next difference of coordinates: of five values, of which a new one
// drives out the highest or the lowest in turn. The turns are part of the format.
// Tested by tests/io/las_test.cpp.
#pragma once

#include <algorithm>
#include <cstdint>

namespace hodt::las {

class MovingMedian {
 public:
  std::int32_t get() const { return sorted_[2]; }

  void add(std::int32_t value) {
    if (drops_highest_) {
      drops_highest_ = value < sorted_[2];
      for (int i = 3; i >= 0; --i) {
        sorted_[i + 1] = std::max(sorted_[i], value);
        value = std::min(sorted_[i], value);
      }
      sorted_[0] = value;
    } else {
      drops_highest_ = value <= sorted_[2];
      for (int i = 1; i <= 4; ++i) {
        sorted_[i - 1] = std::min(sorted_[i], value);
        value = std::max(sorted_[i], value);
      }
      sorted_[4] = value;
    }
  }

 private:
  std::int32_t sorted_[5] = {};
  bool drops_highest_ = true;
};

}  // namespace hodt::las
