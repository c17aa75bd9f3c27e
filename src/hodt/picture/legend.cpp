#include "hodt/picture/legend.h"

#include <algorithm>
#include <cmath>

namespace hodt {
namespace {

constexpr double kTextSize = 14;
constexpr double kLineHeight = 26;
constexpr double kSymbolWidth = 34;
constexpr double kLabelIndent = 46;

void draw_symbol(Svg& svg, const LineStyle& style, double x, double y) {
  const auto line = [&](std::string_view colour, double width, double opacity) {
    svg.add(
        "<path fill=\"none\" stroke-linecap=\"round\" stroke=\"{}\" stroke-width=\"{:.1f}\" "
        "stroke-opacity=\"{}\" d=\"M{:.1f} {:.1f}h{:.1f}\"/>\n",
        colour, width, opacity, x, y, kSymbolWidth);
  };
  line(style.colour, style.width, style.opacity);
}

void draw_symbol(Svg& svg, const MarkStyle& style, double x, double y) {
  MarkStyle in_legend = style;
  in_legend.kind = "key";
  draw_mark(svg, {x + kSymbolWidth / 2, y}, in_legend, 1);
}

/// The largest of 1, 2, 5, 10, ... (and their tenths) that is at most `most`, which is positive.
double round_number(double most) {
  const double power = std::pow(10, std::floor(std::log10(most)));
  if (5 * power <= most) return 5 * power;
  return 2 * power <= most ? 2 * power : power;
}

std::string length_label(double length, const std::string& unit) {
  if (unit == "m" && length >= 1000) return fmt::format("{:g} km", length / 1000);
  if (unit == "°") return fmt::format("{:g}°", length);
  return fmt::format("{:g} {}", length, unit.empty() ? "units of x and y" : unit);
}

}  // namespace

double draw_items(Svg& svg, const std::vector<LegendItem>& items, double x, double y) {
  for (const LegendItem& item : items) {
    std::visit([&](const auto& style) { draw_symbol(svg, style, x, y - 4.5); }, item.style);
    svg.text(x + kLabelIndent, y, kTextSize, item.label);
    y += kLineHeight;
  }
  return y;
}

void draw_scale_bar(Svg& svg, const Frame& frame, const std::string& unit, double x, double y) {
  constexpr double most_pixels = 150;
  const double units_to_pixel = frame.view.width() / frame.width;
  const double length = round_number(most_pixels * units_to_pixel);
  const double pixels = length / units_to_pixel;
  svg.add(
      "<path class=\"scale\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\" "
      "d=\"M{:.1f} {:.1f}v6h{:.1f}v-6\"/>\n",
      kInk, x, y - 8, pixels);
  svg.text(x + pixels + 9, y, kTextSize, length_label(length, unit));
}

void draw_height_bar(Svg& svg, const GroundColours& colours, const std::string& unit, double x,
                     double y) {
  constexpr int patches = 24;
  constexpr double patch = 5;
  for (int i = 0; i < patches; ++i) {
    const Colour c = tint((i + 0.5) / patches);
    svg.add(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"11\" "
        "fill=\"#{:02x}{:02x}{:02x}\"/>\n",
        x + i * patch, y - 10, patch + 0.3, c.red, c.green, c.blue);
  }
  const double low = colours.low(), high = colours.high();
  svg.text(x + patches * patch + 9, y, kTextSize,
           fmt::format("{}{} to {}{}", unit.empty() ? "z " : "", number_within(low, low, high),
                       number_within(high, low, high), unit.empty() ? "" : " " + unit));
}

std::string number_within(double value, double low, double high) {
  const double range = high - low;
  if (!(range > 0) || !std::isfinite(range)) return fmt::format("{:.6g}", value);
  const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(range))), 0, 12);
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  return text.size() <= 20 ? text : fmt::format("{:.6g}", value);
}

}  // namespace hodt
