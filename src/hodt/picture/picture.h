// A picture of what a higher order changes: one window of a terrain before and after.
#pragma once

#include <string>

#include "hodt/tin/tin.h"

namespace hodt {

struct PictureOptions {
  /// The first line of the text beside the map.
  std::string title = "Delaunay and higher order Delaunay";
  /// A few sentences under the legend; may be empty.
  std::string caption;
  /// Side of the square window in the points' unit; 0: such that about 700 points are in it.
  double window = 0;
};

/// An SVG document that shows the window with most vanished local minima: the ground shaded, the
/// edges that both triangulations have, those that only one has, the local minima that vanish and
/// those that stay. The same input gives the same bytes. Throws ParameterError unless both have the
/// same vertices, with heights.
std::string svg_comparison(const Tin& before, const Tin& after, const PictureOptions& options = {});

}  // namespace hodt
