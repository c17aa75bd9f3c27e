// What is beside the maps of a picture: what its lines and marks mean, and how large all is.
// Internal to this layer.
// Tested by tests/picture/picture_test.cpp.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "hodt/picture/frame.h"
#include "hodt/picture/ground.h"
#include "hodt/picture/panel.h"
#include "hodt/picture/svg.h"

namespace hodt {

struct LegendItem {
  std::variant<LineStyle, MarkStyle> style;
  std::string label;
};

/// Draws a column of items below a place of the page; returns where the next one would be.
double draw_items(Svg& svg, const std::vector<LegendItem>& items, double x, double y);

/// A line of a round length with its label: "200 m", "5 km", "0.01°".
void draw_scale_bar(Svg& svg, const Frame& frame, const std::string& unit, double x, double y);

/// The tints and the heights that they stand for.
void draw_height_bar(Svg& svg, const GroundColours& colours, const std::string& unit, double x,
                     double y);

/// A number with three digits of what is between `low` and `high`.
std::string number_within(double value, double low, double high);

}  // namespace hodt
