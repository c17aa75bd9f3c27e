// Where on the page a part of the terrain is. Internal to this layer.
// Tested by tests/picture/picture_test.cpp.
#pragma once

#include "hodt/picture/window.h"
#include "hodt/tin/tin.h"

namespace hodt {

struct Frame {
  Window view;
  double left = 0, top = 0;  ///< of the rectangle on the page
  double width = 0, height = 0;

  Point pixel(const Point& p) const {
    return {left + (p.x - view.low.x) / view.width() * width,
            top + (view.high.y - p.y) / view.height() * height};
  }
};

/// Whether the bounding box of the vertices meets the window.
template <class Vertices>
bool meets(const Window& window, const Tin& tin, const Vertices& vertices) {
  Window box{tin.points.xy[vertices[0]], tin.points.xy[vertices[0]]};
  for (const Index vertex : vertices) box.include(tin.points.xy[vertex]);
  return window.meets(box);
}

}  // namespace hodt
