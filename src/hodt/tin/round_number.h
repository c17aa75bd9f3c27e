// Round numbers to suggest in place of one that is too small.
// Tested by tests/tin/raster_test.cpp.
#pragma once

#include <charconv>
#include <cmath>
#include <string>

#include <fmt/format.h>

namespace hodt {

/// The first number above a positive one, of 1, 2 or 5 times a power of ten, for which does(number)
/// is true; there is one.
template <class Does>
double next_round_number(double above, const Does& does) {
  for (int power = static_cast<int>(std::floor(std::log10(above)));; ++power)
    for (const int digit : {1, 2, 5}) {
      // Read from text, which gives the double that is nearest.
      const std::string text = fmt::format("{}e{}", digit, power);
      double number = 0;
      std::from_chars(text.data(), text.data() + text.size(), number);
      if (number > above && does(number)) return number;
    }
}

}  // namespace hodt
