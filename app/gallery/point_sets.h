// The points of the figures, picked so that each shows what it is about.
// Tested by tests/CMakeLists.txt.
#pragma once

#include <cstddef>

#include "hodt/geometry/point_set.h"

namespace gallery {

/// Eighteen points, for orders of edges and triangles.
inline hodt::PointSet eighteen() {
  return {{{29, 47},
           {48, 16},
           {24, 90},
           {5, 10},
           {17, 31},
           {64, 26},
           {51, 82},
           {3, 58},
           {62, 58},
           {97, 2},
           {89, 34},
           {43, 30},
           {77, 8},
           {24, 18},
           {93, 74},
           {71, 45},
           {20, 76},
           {82, 63}},
          {}};
}

/// An edge from the first point to the second, and what it crosses.
inline hodt::PointSet with_long_edge() {
  return {{{0, 0},
           {60, 3},
           {10, 13},
           {28, 17},
           {47, 13},
           {17, -11},
           {39, -12},
           {-12, 16},
           {12, 33},
           {45, 34},
           {75, 18},
           {74, -14},
           {52, -30},
           {21, -32},
           {-12, -16}},
          {}};
}

/// Sixty points, for what all edges together make.
inline hodt::PointSet sixty() {
  return {{{60, 38},  {26, 92},  {101, 61}, {39, 11},  {17, 2},   {102, 70}, {74, 97},  {15, 28},
           {133, 68}, {92, 35},  {67, 27},  {6, 82},   {49, 21},  {79, 37},  {95, 11},  {86, 85},
           {63, 60},  {71, 11},  {140, 38}, {1, 37},   {130, 24}, {105, 54}, {73, 55},  {115, 20},
           {118, 80}, {71, 66},  {136, 82}, {120, 89}, {87, 18},  {50, 8},   {105, 25}, {112, 35},
           {47, 45},  {111, 95}, {25, 7},   {60, 15},  {6, 5},    {21, 36},  {83, 2},   {105, 79},
           {49, 56},  {64, 48},  {2, 46},   {11, 58},  {24, 56},  {14, 94},  {43, 76},  {10, 69},
           {125, 74}, {9, 15},   {51, 30},  {125, 4},  {53, 98},  {80, 72},  {29, 72},  {75, 84},
           {32, 98},  {55, 0},   {101, 98}, {97, 28}},
          {}};
}

/// The same on a slope with hollows.
inline hodt::PointSet rough_slope() {
  hodt::PointSet points = sixty();
  for (std::size_t i = 0; i < points.size(); ++i)
    points.z.push_back(0.8 * points.xy[i].y + static_cast<double>(i * 46 % 60));
  return points;
}

/// A valley that falls from north to south between two hills.
inline hodt::PointSet valley() {
  return {{{0, 4.1},
           {0.3, 0},
           {-0.2, -4},
           {-1.2, 2.2},
           {1.1, 1.9},
           {-4, 4.5},
           {-4, 0.4},
           {-3.6, -3.6},
           {4, 4},
           {3.9, -0.2},
           {3.4, -4},
           {-1.4, 6.5},
           {1.7, 6.3}},
          {12, 8, 4, 25, 27, 40, 38, 30, 42, 35, 28, 21, 23}};
}

/// Four quadrilaterals around a square of minima and maxima.
inline hodt::PointSet ring() {
  return {{{-1, -1},
           {1, -1.1},
           {1.1, 1},
           {-0.95, 1.05},
           {0.1, -0.05},
           {-1.1, -3},
           {1.05, -3.05},
           {3, -1.05},
           {3.1, 1.1},
           {1.1, 3},
           {-1, 3.1},
           {-3, 1.1},
           {-3.05, -0.95}},
          {30, 60, 31, 61, 45, 90, 10, 11, 91, 92, 12, 13, 93}};
}

}  // namespace gallery
