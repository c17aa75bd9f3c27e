// Measures of one's own: functions that objectives take as they take the built-in measures.
#pragma once

#include <functional>
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
};

}  // namespace hodt
