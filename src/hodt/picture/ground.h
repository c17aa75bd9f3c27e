// The ground of a terrain, shaded. Internal to this layer.
// Tested by tests/picture/picture_test.cpp.
#pragma once

#include "hodt/picture/frame.h"
#include "hodt/picture/image.h"
#include "hodt/picture/relief.h"
#include "hodt/picture/svg.h"

namespace hodt {

/// How the ground of a window is coloured: the tints from its lowest to its highest vertex, slopes
/// such that the usual one is shown well.
class GroundColours {
 public:
  /// Requires heights.
  GroundColours(const Tin& tin, const Window& window);

  Colour of(const Tin& tin, const std::array<Index, 3>& corner) const;
  double low() const { return low_; }
  double high() const { return high_; }

 private:
  double low_ = 0, high_ = 0;
  double lift_ = 1;
};

/// Draws the triangles one by one if they are few; else, if there is something to pack images, as
/// an image.
void draw_ground(Svg& svg, const Frame& frame, const Tin& tin, const GroundColours& colours,
                 const ImagePacker& pack);

}  // namespace hodt
