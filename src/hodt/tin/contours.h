// Contour lines of a TIN: the level sets of its piecewise linear surface.
// Tested by tests/tin/contours_test.cpp.
#pragma once

#include <span>
#include <vector>

#include "hodt/base/progress.h"
#include "hodt/geometry/point.h"
#include "hodt/tin/tin.h"

namespace hodt {

/// A line at one height. Higher ground is on its left, so it runs counter-clockwise around summits.
struct ContourLine {
  double level = 0;
  /// Two positions or more, no two alike next to each other. A closed line repeats the first at its
  /// end; others end on the border of the mesh.
  std::vector<Point> xy;

  bool is_closed() const { return xy.front() == xy.back(); }
};

/// The contour lines at the levels, which are finite and ascend strictly: sorted by level, and each
/// level's in the order of the first edge that they cross.
///
/// They bound what is at the level or above it. So a flat triangle at the level has no line across
/// it, but one along its edges towards lower ground; a flat bottom at the level has none, and a
/// summit that just reaches it neither. No two lines cross, and each crosses every edge once at
/// most. Along a ridge that is at the level, two run side by side, one for each flank. A line meets
/// a vertex at the level exactly; elsewhere each of its positions is on an edge, rounded.
///
/// Triangles may be given in either direction. Throws ParameterError if the mesh has no heights,
/// the levels are none, or they cut triangles into more than a thousand million pieces of lines;
/// InputError if an edge has more than two triangles. O(n + m log m) for m pieces.
std::vector<ContourLine> contours(const Tin& tin, std::span<const double> levels,
                                  const Progress& progress = {});

/// The levels base + i * interval, for whole numbers i, that the surface reaches. Throws
/// ParameterError if the interval is not positive, either is not finite, there would be more than
/// ten million, or they are nearer to each other than doubles of their size.
std::vector<double> contour_levels(const Tin& tin, double interval, double base = 0);

}  // namespace hodt
