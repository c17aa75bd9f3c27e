#include "hodt/picture/panel.h"

#include <algorithm>
#include <iterator>

namespace hodt {
namespace {

/// Of a path: renderers take long for those of very many pieces.
constexpr std::size_t kPieces = 400;
constexpr double kHalo = 2.6;

}  // namespace

void Panel::edges(std::span<const Edge> edges, const LineStyle& style) const {
  std::vector<std::array<Point, 2>> shown;
  for (const Edge& edge : edges)
    if (meets(frame_.view, tin_, edge))
      shown.push_back({tin_.points.xy[edge[0]], tin_.points.xy[edge[1]]});
  segments(shown, style);
}

void Panel::segments(std::span<const std::array<Point, 2>> segments, const LineStyle& style) const {
  if (style.has_halo) line(segments, style, "#ffffff", style.width * scale_ + kHalo * scale_, 0.75);
  line(segments, style, style.colour, style.width * scale_, style.opacity);
}

void Panel::line(std::span<const std::array<Point, 2>> segments, const LineStyle& style,
                 std::string_view colour, double width, double opacity) const {
  if (segments.empty()) return;
  svg_.add(
      "<g class=\"{}\" fill=\"none\" stroke-linecap=\"round\" stroke=\"{}\" "
      "stroke-width=\"{:.2f}\" stroke-opacity=\"{}\">\n",
      style.kind, colour, width, opacity);
  for (std::size_t first = 0; first < segments.size(); first += kPieces) {
    std::string path;
    for (const auto& [p, q] : segments.subspan(first, std::min(kPieces, segments.size() - first))) {
      const Point a = frame_.pixel(p);
      const Point b = frame_.pixel(q);
      fmt::format_to(std::back_inserter(path), "M{:.1f} {:.1f}L{:.1f} {:.1f}", a.x, a.y, b.x, b.y);
    }
    svg_.add("<path d=\"{}\"/>\n", path);
  }
  svg_.add("</g>\n");
}

void Panel::marks(std::span<const Index> vertices, const MarkStyle& style) const {
  for (const Index vertex : vertices)
    if (frame_.view.contains(tin_.points.xy[vertex]))
      draw_mark(svg_, frame_.pixel(tin_.points.xy[vertex]), style, scale_);
}

void draw_mark(Svg& svg, const Point& at, const MarkStyle& style, double scale) {
  const double r = style.radius * scale;
  switch (style.shape) {
    case MarkStyle::Shape::circle:
      svg.add("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"", style.kind, at.x,
              at.y, r);
      break;
    case MarkStyle::Shape::peak:
      svg.add("<path class=\"{} peak\" d=\"M{:.1f} {:.1f}l{:.1f} {:.1f}h{:.1f}z\"", style.kind,
              at.x, at.y - 1.2 * r, 1.1 * r, 2 * r, -2.2 * r);
      break;
    case MarkStyle::Shape::square:
      svg.add("<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"",
              style.kind, at.x - r, at.y - r, 2 * r, 2 * r);
      break;
  }
  svg.add(" fill=\"{}\" fill-opacity=\"{}\" stroke=\"{}\" stroke-width=\"{:.1f}\"/>\n", style.fill,
          style.fill_opacity, kInk, style.stroke * scale);
}

}  // namespace hodt
