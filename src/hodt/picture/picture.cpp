#include "hodt/picture/picture.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/picture/difference.h"
#include "hodt/picture/markup.h"
#include "hodt/picture/relief.h"
#include "hodt/picture/window.h"

namespace hodt {
namespace {

// The page, in pixels: a square map, and text to its right.
constexpr double kWidth = 1200;
constexpr double kHeight = 900;
constexpr double kMapLeft = 20;
constexpr double kMapTop = 20;
constexpr double kMapSide = 860;
constexpr double kTextLeft = 912;
constexpr std::size_t kTextColumns = 36;  // characters to a line of the caption

constexpr double kPointsShown = 700;
constexpr std::string_view kInk = "#2b2a28";

// How each thing looks, on the map as in the legend.
constexpr std::string_view kKeptStyle =
    R"(stroke="#4a443a" stroke-opacity="0.34" stroke-width="0.8")";
constexpr std::string_view kRemovedStyle =
    R"(stroke="#c2331f" stroke-width="1.9" stroke-dasharray="5 3.5")";
constexpr std::string_view kAddedStyle = R"(stroke="#0f55a8" stroke-width="2.8")";
constexpr std::string_view kAddedHalo =
    R"(stroke="#ffffff" stroke-opacity="0.75" stroke-width="5")";
constexpr std::string_view kVanishedStyle =
    R"(r="6.5" fill="#f7b52c" stroke="#2b2a28" stroke-width="2")";
constexpr std::string_view kRemainingStyle =
    R"(r="5.5" fill="#ffffff" fill-opacity="0.5" stroke="#2b2a28" stroke-width="1.7")";

/// Breaks text at spaces into lines of at most `columns` characters, longer words aside.
std::vector<std::string> wrapped(std::string_view text, std::size_t columns) {
  std::vector<std::string> lines;
  std::string line;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (word.empty()) continue;
    if (!line.empty() && line.size() + 1 + word.size() > columns) {
      lines.push_back(line);
      line.clear();
    }
    if (!line.empty()) line += ' ';
    line += word;
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

/// Collects a document; coordinates go out with one decimal.
class Svg {
 public:
  template <class... Args>
  void add(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
  }
  void text(double x, double y, double size, std::string_view content, std::string_view more = "") {
    add("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\"{}>{}</text>\n", x, y, size, more,
        escaped(content));
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

/// The map: what of the two triangulations is in the window, drawn from the ground up.
class Map {
 public:
  Map(Svg& svg, const Tin& tin, const Window& window) : svg_(svg), tin_(tin), window_(window) {}

  void ground() const {
    const auto [low, high] = height_range();
    const double lift = exaggeration();
    std::map<Colour, std::string> paths;
    for (const auto& corner : tin_.triangles) {
      if (!shown(corner)) continue;
      const double height = (z(corner[0]) + z(corner[1]) + z(corner[2])) / 3;
      const Point slope = gradient(corner);
      const Colour colour =
          shaded(high > low ? (height - low) / (high - low) : 0.5, lift * slope.x, lift * slope.y);
      std::string& path = paths[colour];
      for (int i = 0; i < 3; ++i) {
        const Point p = pixel(corner[i]);
        fmt::format_to(std::back_inserter(path), "{}{:.1f} {:.1f}", i == 0 ? 'M' : 'L', p.x, p.y);
      }
      path += 'Z';
    }
    // The thin stroke closes the hairlines between neighbours.
    svg_.add("<g stroke-width=\"0.8\" stroke-linejoin=\"round\">\n");
    for (const auto& [colour, path] : paths) {
      const std::string name =
          fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue);
      svg_.add("<path fill=\"{0}\" stroke=\"{0}\" d=\"{1}\"/>\n", name, path);
    }
    svg_.add("</g>\n");
  }

  void edges(std::string_view kind, const std::vector<Edge>& edges, std::string_view style) const {
    std::string path;
    for (const Edge& edge : edges) {
      if (!shown(edge)) continue;
      const Point a = pixel(edge[0]);
      const Point b = pixel(edge[1]);
      fmt::format_to(std::back_inserter(path), "M{:.1f} {:.1f}L{:.1f} {:.1f}", a.x, a.y, b.x, b.y);
    }
    svg_.add("<path class=\"{}\" fill=\"none\" stroke-linecap=\"round\" {} d=\"{}\"/>\n", kind,
             style, path);
  }

  /// Draws a circle at each of the vertices in the window, and says how many.
  std::size_t markers(std::string_view kind, const std::vector<Index>& vertices,
                      std::string_view style) const {
    std::size_t count = 0;
    for (const Index vertex : vertices) {
      if (!window_.contains(tin_.points.xy[vertex])) continue;
      const Point p = pixel(vertex);
      svg_.add("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" {}/>\n", kind, p.x, p.y, style);
      ++count;
    }
    return count;
  }

  struct Range {
    double low, high;
  };
  Range height_range() const {
    bool first = true;
    Range range{0, 0};
    for (Index vertex = 0; vertex < tin_.points.size(); ++vertex) {
      if (!window_.contains(tin_.points.xy[vertex])) continue;
      range = first ? Range{z(vertex), z(vertex)}
                    : Range{std::min(range.low, z(vertex)), std::max(range.high, z(vertex))};
      first = false;
    }
    return range;
  }

 private:
  double z(Index vertex) const { return tin_.points.z[vertex]; }

  Point pixel(Index vertex) const {
    const Point& p = tin_.points.xy[vertex];
    const double scale = kMapSide / window_.side;
    return {kMapLeft + (p.x - window_.south_west.x) * scale,
            kMapTop + kMapSide - (p.y - window_.south_west.y) * scale};
  }

  /// The bounding box of the vertices meets the window.
  template <class Vertices>
  bool shown(const Vertices& vertices) const {
    const Point& first = tin_.points.xy[vertices[0]];
    Point low = first;
    Point high = first;
    for (const Index vertex : vertices) {
      const Point& p = tin_.points.xy[vertex];
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return low.x <= window_.south_west.x + window_.side && high.x >= window_.south_west.x &&
           low.y <= window_.south_west.y + window_.side && high.y >= window_.south_west.y;
  }

  /// How the plane through a triangle rises to the east and to the north.
  Point gradient(const std::array<Index, 3>& corner) const {
    const Point& a = tin_.points.xy[corner[0]];
    const Point& b = tin_.points.xy[corner[1]];
    const Point& c = tin_.points.xy[corner[2]];
    const double ab = z(corner[1]) - z(corner[0]);
    const double ac = z(corner[2]) - z(corner[0]);
    const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (area == 0) return {};
    return {(ab * (c.y - a.y) - ac * (b.y - a.y)) / area,
            (ac * (b.x - a.x) - ab * (c.x - a.x)) / area};
  }

  /// What brings the typical slope to one that the lamp shows well.
  double exaggeration() const {
    std::vector<double> squares;
    for (const auto& corner : tin_.triangles) {
      if (!shown(corner)) continue;
      const Point slope = gradient(corner);
      squares.push_back(slope.x * slope.x + slope.y * slope.y);
    }
    if (squares.empty()) return 1;
    const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
    std::nth_element(squares.begin(), middle, squares.end());
    return *middle > 0 ? 0.45 / std::sqrt(*middle) : 1;
  }

  Svg& svg_;
  const Tin& tin_;
  const Window& window_;
};

/// The largest of 1, 2, 5, 10, ... (and their tenths) that is at most `most`.
double round_number(double most) {
  double power = 1;
  while (power * 10 <= most) power *= 10;
  while (power > most) power /= 10;
  if (5 * power <= most) return 5 * power;
  return 2 * power <= most ? 2 * power : power;
}

void scale_bar(Svg& svg, const Window& window, double x, double y) {
  const double length = round_number(window.side / 5);
  const double pixels = length * kMapSide / window.side;
  svg.add(
      "<path fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\" d=\"M{:.1f} {:.1f}v6h{:.1f}v-6\"/>\n",
      kInk, x, y - 6, pixels);
  const std::string label =
      length >= 1000 ? fmt::format("{:g} km", length / 1000) : fmt::format("{:g} m", length);
  svg.text(x + pixels + 9, y + 2, 13, label);
}

void height_bar(Svg& svg, const Map::Range& range, double x, double y) {
  constexpr int kPatches = 24;
  constexpr double kPatch = 5;
  for (int i = 0; i < kPatches; ++i) {
    const Colour c = tint((i + 0.5) / kPatches);
    svg.add(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"10\" "
        "fill=\"#{:02x}{:02x}{:02x}\"/>\n",
        x + i * kPatch, y - 10, kPatch + 0.3, c.red, c.green, c.blue);
  }
  svg.text(x + kPatches * kPatch + 9, y, 13,
           fmt::format("{:.0f} to {:.0f} m", range.low, range.high));
}

/// What the text beside the map tells.
struct Counts {
  std::size_t before, after;                  // local minima of the whole terrain
  std::size_t vanished_here, remaining_here;  // in the window
};

void legend_line(Svg& svg, double y, std::string_view style, std::string_view label) {
  svg.add("<path fill=\"none\" stroke-linecap=\"round\" {} d=\"M{:.1f} {:.1f}h34\"/>\n", style,
          kTextLeft, y - 4.5);
  svg.text(kTextLeft + 48, y, 14, label);
}

void legend_circle(Svg& svg, double y, std::string_view style, std::string_view label) {
  svg.add("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" {}/>\n", kTextLeft + 17, y - 4.5, style);
  svg.text(kTextLeft + 48, y, 14, label);
}

void side_text(Svg& svg, const PictureOptions& options, const Counts& counts, const Window& window,
               const Map::Range& heights) {
  double y = kMapTop + 18;
  for (const std::string& line : wrapped(options.title, 26)) {
    svg.text(kTextLeft, y, 19, line, " font-weight=\"bold\"");
    y += 25;
  }
  y += 34;
  svg.text(kTextLeft, y, 38, fmt::format("{} → {}", counts.before, counts.after),
           " font-weight=\"bold\" fill=\"#0f55a8\"");
  y += 23;
  svg.text(kTextLeft, y, 14, "local minima of the whole terrain");
  y += 52;
  legend_circle(svg, y, kVanishedStyle,
                fmt::format("vanishing minimum ({} here)", counts.vanished_here));
  y += 30;
  legend_circle(svg, y, kRemainingStyle,
                fmt::format("remaining minimum ({} here)", counts.remaining_here));
  y += 30;
  legend_line(svg, y, kRemovedStyle, "Delaunay edge, replaced");
  y += 30;
  legend_line(svg, y, kAddedStyle, "new edge");
  y += 30;
  legend_line(svg, y, kKeptStyle, "edge of both");
  y += 56;
  for (const std::string& line : wrapped(options.caption, kTextColumns)) {
    svg.text(kTextLeft, y, 14, line);
    y += 20;
  }
  height_bar(svg, heights, kTextLeft, kMapTop + kMapSide - 34);
  scale_bar(svg, window, kTextLeft, kMapTop + kMapSide - 4);
}

double automatic_side(const PointSet& points) {
  const auto [west, east] = std::minmax_element(
      points.xy.begin(), points.xy.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
  const auto [south, north] = std::minmax_element(
      points.xy.begin(), points.xy.end(), [](const Point& a, const Point& b) { return a.y < b.y; });
  const double width = east->x - west->x;
  const double height = north->y - south->y;
  const double share = std::min(1.0, kPointsShown / static_cast<double>(points.size()));
  return std::min({std::sqrt(width * height * share), width, height});
}

void require_same_points(const Tin& before, const Tin& after) {
  if (before.points.xy != after.points.xy || before.points.z != after.points.z) {
    throw ParameterError("only triangulations of the same points can be compared in a picture");
  }
  if (before.triangles.empty() || after.triangles.empty() || !before.points.has_heights()) {
    throw ParameterError("a picture of local minima needs triangles of points with heights");
  }
}

}  // namespace

std::string svg_comparison(const Tin& before, const Tin& after, const PictureOptions& options) {
  require_same_points(before, after);
  const PointSet& points = after.points;
  const Difference changes = difference(before, after);
  std::vector<Point> targets;
  for (const Index vertex : changes.vanished_minima) targets.push_back(points.xy[vertex]);
  const Window window =
      best_window(points.xy, targets, options.window > 0 ? options.window : automatic_side(points));

  Svg svg;
  svg.add(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" font-family=\"'DejaVu Sans', Verdana, sans-serif\" fill=\"{2}\">\n",
      kWidth, kHeight, kInk);
  svg.add("<title>{}</title>\n", escaped(options.title));
  svg.add("<rect width=\"{}\" height=\"{}\" fill=\"#fdfcf9\"/>\n", kWidth, kHeight);
  svg.add(
      "<clipPath id=\"map\"><rect x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{2}\"/></clipPath>\n",
      kMapLeft, kMapTop, kMapSide);
  svg.add("<g clip-path=\"url(#map)\">\n");
  const Map map(svg, after, window);
  map.ground();
  map.edges("kept", changes.kept, kKeptStyle);
  map.edges("halo", changes.added, kAddedHalo);
  map.edges("removed", changes.removed, kRemovedStyle);
  map.edges("added", changes.added, kAddedStyle);
  const std::size_t remaining = map.markers("remains", changes.remaining_minima, kRemainingStyle);
  const std::size_t vanished = map.markers("vanished", changes.vanished_minima, kVanishedStyle);
  svg.add("</g>\n");
  svg.add("<rect x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{2}\" fill=\"none\" stroke=\"{3}\"/>\n",
          kMapLeft, kMapTop, kMapSide, kInk);
  side_text(svg, options,
            {changes.minima_before, changes.remaining_minima.size(), vanished, remaining}, window,
            map.height_range());
  svg.add("</svg>\n");
  return svg.take();
}

}  // namespace hodt
