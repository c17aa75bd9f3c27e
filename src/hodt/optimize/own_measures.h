// Measures of one's own: functions that objectives take as they take the built-in measures.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>

namespace hodt {

/// A point as a measure sees it. z is 0 if the points have no heights.
struct Corner {
  double x, y, z;
};

/// A function of a triangle. Its corners come counter-clockwise, always in the same order for the
/// same triangle. It is called by several threads at once, must return the same value each time,
/// and that must be finite and not negative: anything else is a ParameterError.
struct OwnTriangleMeasure {
  std::string name;  ///< as in "min-max-NAME"
  std::function<double(const Corner& a, const Corner& b, const Corner& c)> of;
  bool needs_heights = false;
};

/// A function of two triangles across an edge: abl, counter-clockwise, and bar on its right. Each
/// edge comes in one direction only. The rest is as above.
struct OwnEdgeMeasure {
  std::string name;
  std::function<double(const Corner& a, const Corner& b, const Corner& left, const Corner& right)>
      of;
  bool needs_heights = false;
  /// The same of some edges at a time, if it is there: values[i] of edges[i], which are a, b, left
  /// and right. For functions that take long to be called.
  std::function<void(std::span<const std::array<Corner, 4>> edges, std::span<double> values)>
      of_many = nullptr;
};

}  // namespace hodt
