// The optima of a catalogue against its triangulations, counted one by one.
#pragma once

#include <algorithm>
#include <functional>

#include "oracle.h"
#include <gtest/gtest.h>

namespace oracle {

/// `count` counts the extrema of one of the triangulations.
inline void expect_optima(const Catalogue& catalogue, const Instance& instance,
                          const std::function<ExtremaCount(const Triangles&)>& count) {
  const Optima optima = catalogue.optima(instance);
  for (int k = 0; k <= 4; ++k) {
    int minima = 99, maxima = 99, extrema = 99;
    for (const Triangulation& t : catalogue.triangulations()) {
      if (t.order > k) continue;
      const ExtremaCount found = count(t.triangles);
      minima = std::min(minima, found.minima.total());
      maxima = std::min(maxima, found.maxima.total());
      extrema = std::min(extrema, found.minima.total() + found.maxima.total());
    }
    EXPECT_EQ(Optima::at(optima.minima, k), minima);
    EXPECT_EQ(Optima::at(optima.maxima, k), maxima);
    EXPECT_EQ(Optima::at(optima.extrema, k), extrema);
  }
}

}  // namespace oracle
