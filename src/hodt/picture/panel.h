// One of the maps of a picture: edges and marks on the ground. Internal to this layer.
// Tested by tests/picture/picture_test.cpp.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hodt/picture/difference.h"
#include "hodt/picture/frame.h"
#include "hodt/picture/svg.h"

namespace hodt {

/// How lines look: without halo, an opaque white one below is left out.
struct LineStyle {
  std::string_view kind;
  std::string_view colour;
  double width = 1;
  double opacity = 1;
  bool has_halo = false;
};

/// How marks look.
struct MarkStyle {
  enum class Shape { circle, peak, square };
  std::string_view kind;
  Shape shape = Shape::circle;
  double radius = 1;
  std::string_view fill;
  double fill_opacity = 1;
  double stroke = 1;
};

inline constexpr LineStyle kKeptEdge{"kept", "#4a443a", 0.8, 0.34, false};
inline constexpr LineStyle kRemovedEdge{"removed", "#b3261a", 2.4, 1, true};
inline constexpr LineStyle kBorderEdge{"border", "#2b2a28", 1.6, 0.8, false};
inline constexpr LineStyle kBreakline{"breakline", "#111111", 3.2, 1, true};

inline constexpr MarkStyle kVanished{"vanished", MarkStyle::Shape::circle, 6.5, "#f7b52c", 1, 2};
inline constexpr MarkStyle kWasThere{"gone", MarkStyle::Shape::circle, 3, "#f7b52c", 1, 1};
inline constexpr MarkStyle kRemaining{"remains", MarkStyle::Shape::circle, 5, "#ffffff", 0.7, 1.7};
inline constexpr MarkStyle kHeld{"held", MarkStyle::Shape::circle, 5.5, "#0b4f8a", 1, 1.7};
inline constexpr MarkStyle kMade{"made", MarkStyle::Shape::square, 5, "#56b4e9", 1, 2};

/// The same for maxima.
constexpr MarkStyle as_peak(MarkStyle style) {
  style.shape = MarkStyle::Shape::peak;
  return style;
}

class Panel {
 public:
  /// `scale` shrinks widths and marks where the terrain is dense.
  Panel(Svg& svg, const Frame& frame, const Tin& tin, double scale)
      : svg_(svg), frame_(frame), tin_(tin), scale_(scale) {}

  void edges(std::span<const Edge> edges, const LineStyle& style) const;
  void segments(std::span<const std::array<Point, 2>> segments, const LineStyle& style) const;
  void marks(std::span<const Index> vertices, const MarkStyle& style) const;

 private:
  void line(std::span<const std::array<Point, 2>> segments, const LineStyle& style,
            std::string_view colour, double width, double opacity) const;

  Svg& svg_;
  const Frame& frame_;
  const Tin& tin_;
  double scale_;
};

/// A mark with its middle at a place of the page.
void draw_mark(Svg& svg, const Point& at, const MarkStyle& style, double scale);

}  // namespace hodt
