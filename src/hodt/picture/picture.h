// A picture of what a higher order changes: one window of a terrain before and after, side by side.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "hodt/geometry/point.h"
#include "hodt/picture/image.h"
#include "hodt/picture/window.h"
#include "hodt/tin/tin.h"

namespace hodt {

struct PictureOptions {
  /// What stands above both.
  std::string title = "Delaunay and higher order Delaunay";
  /// What stands above each.
  std::string before = "Delaunay triangulation";
  std::string after = "higher order";
  /// A few sentences below; may be empty.
  std::string caption = {};
  /// The part that is shown, widened if it is very long and narrow. Without one it is the whole
  /// terrain if that is small enough to be looked at, else a square of about 700 points where most
  /// changes, and a small map shows where that is.
  std::optional<Window> window = {};
  /// Which local extrema are marked, where there are heights.
  bool minima = true;
  bool maxima = false;
  /// Minima that were to stay, in ascending order, which are marked apart where they did.
  std::vector<Index> kept = {};
  /// Breaklines, by the ends of their pieces.
  std::vector<std::array<Point, 2>> lines = {};
  /// The unit of coordinates: "m", "ft", "°"; empty: not known. That of heights likewise.
  std::string unit = {};
  std::string height_unit = {};
  /// What packs images. Without one the ground is drawn triangle by triangle, however many there
  /// are, and the small map is not shaded.
  ImagePacker pack = {};
};

struct Picture {
  std::string svg;
  double width = 0, height = 0;  ///< of the page, in pixels
  Window view;                   ///< what is shown
};

/// An SVG document that shows, in two maps, the ground shaded (where there are heights), edges that
/// both triangulations have (if they are few enough to be told apart), those that the first one
/// alone has, those that the second alone has, coloured by their order if `after` tells it, and the
/// local minima that vanish and those that stay. The same input gives the same bytes.
///
/// Throws ParameterError unless both have the same points, if the window has no point in it, and if
/// so much has changed in it that no one could look at the picture.
Picture comparison_picture(const Tin& before, const Tin& after, const PictureOptions& options = {});

}  // namespace hodt
