#include "hodt/order/near_points.h"

#include <algorithm>
#include <cmath>

namespace hodt {

NearPoints::NearPoints() {
  for (auto* array : {&image_x_, &image_y_, &rounding_}) array->fill(0);
  for (auto* array : {&x_, &y_, &r_}) array->fill(0);
}

void NearPoints::clear(double nearest) {
  for (auto* array : {&image_x_, &image_y_, &rounding_}) std::fill_n(array->data(), size_, 0.0f);
  size_ = 1;
  larger_ = 0;
  scale_ = std::ldexp(1.0, -std::clamp(std::ilogb(nearest), -1020, 1000));
}

}  // namespace hodt
