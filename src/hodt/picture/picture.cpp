#include "hodt/picture/picture.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/picture/difference.h"
#include "hodt/picture/frame.h"
#include "hodt/picture/ground.h"
#include "hodt/picture/legend.h"
#include "hodt/picture/order_colours.h"
#include "hodt/picture/panel.h"
#include "hodt/picture/svg.h"
#include "hodt/tin/boundary_edges.h"

namespace hodt {
namespace {

// The page, in pixels: a title, two maps beside or below each other, and three columns of text.
constexpr double kMargin = 24;
constexpr double kMapTop = 100;
constexpr double kHeadingHeight = 34;
constexpr double kMapWidth = 660;
constexpr double kTallestMap = 900;
constexpr double kPageWidth = 2 * kMapWidth + 3 * kMargin;
constexpr double kTextTop = 44;  // below the maps
constexpr double kSmallMap = 170;
constexpr double kCharacter = 0.6;  // width of one, in font sizes

constexpr std::size_t kPointsOfWhole = 2500;
constexpr double kPointsShown = 700;
constexpr std::size_t kPointsWithAllEdges = 12000;
constexpr std::size_t kMostDrawn = 200000;  // makes about 15 MB

bool is_positive(double size) {
  return size > 0 && std::isfinite(size);
}

/// Makes room where the window is so long and narrow that nothing could be seen.
Window widened(Window window) {
  constexpr double narrowest = 0.4, widest = 6;
  const Point middle = window.middle();
  const double width = std::max(window.width(), narrowest * window.height());
  const double height = std::max(window.height(), width / widest);
  if (width > window.width())
    window = {{middle.x - width / 2, window.low.y}, {middle.x + width / 2, window.high.y}};
  if (height > window.height())
    window = {{window.low.x, middle.y - height / 2}, {window.high.x, middle.y + height / 2}};
  return window;
}

/// The whole terrain with a little room around.
Window whole(const PointSet& points) {
  constexpr double room = 0.02;
  const Window box = bounding_box(points.xy);
  const double x = room * box.width(), y = room * box.height();
  return {{box.low.x - x, box.low.y - y}, {box.high.x + x, box.high.y + y}};
}

/// Where most marked vertices vanish, or where most edges change if none does.
Window most_changed(const PointSet& points, const Difference& changes,
                    const PictureOptions& options) {
  std::vector<Point> targets;
  if (options.minima)
    for (const Index v : changes.minima.vanished) targets.push_back(points.xy[v]);
  if (options.maxima)
    for (const Index v : changes.maxima.vanished) targets.push_back(points.xy[v]);
  if (targets.empty())
    for (const auto& [a, b] : changes.added) targets.push_back(points.xy[a]);
  const Window box = bounding_box(points.xy);
  const double share = std::min(1.0, kPointsShown / static_cast<double>(points.size()));
  const double side = std::min({std::sqrt(box.width()) * std::sqrt(box.height()) * std::sqrt(share),
                                box.width(), box.height()});
  return best_window(points.xy, targets, side);
}

Window choose_window(const PointSet& points, const Difference& changes,
                     const PictureOptions& options) {
  if (options.window) return widened(*options.window);
  return widened(points.size() <= kPointsOfWhole ? whole(points)
                                                 : most_changed(points, changes, options));
}

void check(const Tin& before, const Tin& after) {
  if (before.points.xy != after.points.xy || before.points.z != after.points.z)
    throw ParameterError("only triangulations of the same points can be compared in a picture");
  if (before.triangles.empty() || after.triangles.empty())
    throw ParameterError("there is no picture of no triangles");
}

std::size_t count_in(const Window& view, std::span<const Point> points) {
  return static_cast<std::size_t>(std::count_if(points.begin(), points.end(),
                                                [&](const Point& p) { return view.contains(p); }));
}

void check_view(const Window& view, const PointSet& points) {
  const Window box = bounding_box(points.xy);
  if (!is_positive(view.width()) || !is_positive(view.height()))
    throw ParameterError("the window of a picture has to have a width and a height");
  if (count_in(view, points.xy) == 0)
    throw ParameterError(fmt::format(
        "no point is in the picture's window; they are between x {} and {}, y {} and {}", box.low.x,
        box.high.x, box.low.y, box.high.y));
}

/// The document and all that its parts look at.
class Page {
 public:
  Page(const Tin& before, const Tin& after, const PictureOptions& options)
      : before_(before),
        after_(after),
        options_(options),
        changes_(difference(before, after, options.kept)),
        classes_(order_classes(changes_)),
        border_(boundary_edges(after.triangles)),
        view_(choose_window(after.points, changes_, options)) {
    check_view(view_, after.points);
    const std::size_t points = count_in(view_, after.points.xy);
    has_all_edges_ = points <= kPointsWithAllEdges;
    lay_out(points);
    check_amount();
  }

  Picture draw() {
    std::optional<GroundColours> colours;
    if (after_.points.has_heights()) colours.emplace(after_, view_);
    Svg maps;
    draw_map(maps, frames_[0], before_, colours, true);
    draw_map(maps, frames_[1], after_, colours, false);
    const double top = frames_[1].top + frames_[1].height + kTextTop;
    const double bottom =
        std::max({draw_lines_key(maps, column(0), top), draw_marks_key(maps, column(1), top),
                  draw_sizes(maps, column(2), top, colours)});
    const double height = bottom + kMargin / 2;

    Svg svg;
    svg.add(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
        "width=\"{0:.0f}\" height=\"{1:.0f}\" font-family=\"'DejaVu Sans', Verdana, sans-serif\" "
        "fill=\"{2}\">\n",
        kPageWidth, height, kInk);
    svg.add("<title>{}</title>\n", escaped(options_.title));
    svg.add("<rect width=\"{:.0f}\" height=\"{:.0f}\" fill=\"#fdfcf9\"/>\n", kPageWidth, height);
    const auto columns = static_cast<std::size_t>((kPageWidth - 2 * kMargin) / (22 * kCharacter));
    const std::vector<std::string> title = wrapped(options_.title, columns);
    if (!title.empty())
      svg.text(kMargin, kMargin + 20, 22, title.size() == 1 ? title[0] : title[0] + " …",
               " font-weight=\"bold\"");
    svg.add("{}</svg>\n", maps.take());
    return {svg.take(), kPageWidth, std::round(height), view_};
  }

 private:
  static double column(int i) { return kMargin + i * (kPageWidth - kMargin) / 3; }
  static std::size_t columns_of(double width, double size) {
    return static_cast<std::size_t>(width / (size * kCharacter));
  }

  void lay_out(std::size_t points) {
    const double aspect = view_.width() / view_.height();
    const bool is_stacked = aspect > 1.7;
    double width = is_stacked ? kPageWidth - 2 * kMargin : kMapWidth;
    const double height = std::min(width / aspect, kTallestMap);
    width = height * aspect;
    frames_[0] = {view_, kMargin, kMapTop, width, height};
    frames_[1] = frames_[0];
    if (is_stacked)
      frames_[1].top += height + kHeadingHeight + 12;
    else
      frames_[1].left = kMargin + kMapWidth + kMargin;
    const double spacing = std::sqrt(width * height / static_cast<double>(points));
    scale_ = std::clamp(spacing / 18, 0.35, 1.0);
  }

  void check_amount() const {
    std::size_t count = 0;
    for (const std::vector<Edge>* edges : {&changes_.removed, &changes_.added})
      for (const Edge& edge : *edges) count += meets(view_, after_, edge) ? 1 : 0;
    for (const ExtremaChange* extrema : shown_extrema())
      for (const auto* vertices :
           {&extrema->vanished, &extrema->remaining, &extrema->kept, &extrema->made})
        count += here(*vertices);
    if (count > kMostDrawn)
      throw ParameterError(fmt::format(
          "{} changed edges and local extrema are in the picture's window, of which nobody could "
          "tell one from the other; choose a smaller one",
          count));
  }

  std::vector<const ExtremaChange*> shown_extrema() const {
    std::vector<const ExtremaChange*> shown;
    if (!after_.points.has_heights()) return shown;
    if (options_.minima) shown.push_back(&changes_.minima);
    if (options_.maxima) shown.push_back(&changes_.maxima);
    return shown;
  }

  std::size_t here(const std::vector<Index>& vertices) const {
    return static_cast<std::size_t>(std::count_if(vertices.begin(), vertices.end(), [&](Index v) {
      return view_.contains(after_.points.xy[v]);
    }));
  }
  std::size_t here(const std::vector<Edge>& edges) const {
    return static_cast<std::size_t>(std::count_if(
        edges.begin(), edges.end(), [&](const Edge& e) { return meets(view_, after_, e); }));
  }

  void draw_map(Svg& svg, const Frame& frame, const Tin& tin,
                const std::optional<GroundColours>& colours, bool is_before) const {
    const std::string heading = heading_of(is_before);
    const std::vector<std::string> lines = wrapped(heading, columns_of(frame.width, 15));
    if (!lines.empty()) svg.text(frame.left, frame.top - 12, 15, lines[0], " font-weight=\"bold\"");
    const std::string_view id = is_before ? "before" : "after";
    const std::string box =
        fmt::format("x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"", frame.left,
                    frame.top, frame.width, frame.height);
    svg.add("<clipPath id=\"{0}\"><rect {1}/></clipPath>\n<g clip-path=\"url(#{0})\">\n", id, box);
    if (colours) draw_ground(svg, frame, tin, *colours, options_.pack);
    const Panel panel(svg, frame, tin, scale_);
    if (has_all_edges_) panel.edges(changes_.kept, kKeptEdge);
    panel.edges(border_, kBorderEdge);
    if (is_before) {
      panel.edges(changes_.removed, kRemovedEdge);
    } else {
      for (const OrderClass& each : classes_) panel.edges(each.edges, each.style);
    }
    panel.segments(options_.lines, kBreakline);
    if (options_.minima)
      draw_marks(panel, changes_.minima, is_before, [](auto style) { return style; });
    if (options_.maxima) draw_marks(panel, changes_.maxima, is_before, as_peak);
    svg.add("</g>\n<rect {} fill=\"none\" stroke=\"{}\"/>\n", box, kInk);
  }

  template <class Restyle>
  static void draw_marks(const Panel& panel, const ExtremaChange& extrema, bool is_before,
                         const Restyle& restyle) {
    panel.marks(extrema.remaining, restyle(kRemaining));
    panel.marks(extrema.kept, restyle(kHeld));
    panel.marks(extrema.vanished, restyle(is_before ? kVanished : kWasThere));
    if (!is_before) panel.marks(extrema.made, restyle(kMade));
  }

  std::string heading_of(bool is_before) const {
    std::string heading = is_before ? options_.before : options_.after;
    if (!after_.points.has_heights()) return heading;
    const auto count = [&](const ExtremaChange& extrema) {
      return is_before ? extrema.before() : extrema.after();
    };
    if (options_.minima) heading += fmt::format(": {} local minima", count(changes_.minima));
    if (options_.maxima)
      heading +=
          fmt::format("{} {} local maxima", options_.minima ? "," : ":", count(changes_.maxima));
    return heading;
  }

  double draw_lines_key(Svg& svg, double x, double y) const {
    std::vector<LegendItem> items;
    if (has_all_edges_) items.push_back({kKeptEdge, "edge of both"});
    items.push_back(
        {kRemovedEdge, fmt::format("edge that goes ({} here)", here(changes_.removed))});
    for (const OrderClass& each : classes_)
      items.push_back({each.style, fmt::format("{} ({} here)", each.label(), here(each.edges))});
    if (!options_.lines.empty()) items.push_back({kBreakline, "breakline"});
    if (here(border_) > 0) items.push_back({kBorderEdge, "border"});
    return draw_items(svg, items, x, y);
  }

  double draw_marks_key(Svg& svg, double x, double y) const {
    std::vector<LegendItem> items;
    const auto add = [&](const ExtremaChange& extrema, std::string_view name, const auto& restyle) {
      items.push_back({restyle(kVanished),
                       fmt::format("local {} that goes ({} here)", name, here(extrema.vanished))});
      if (here(extrema.vanished) > 0) items.push_back({restyle(kWasThere), "where it was"});
      items.push_back({restyle(kRemaining), fmt::format("local {} that stays ({} here)", name,
                                                        here(extrema.remaining))});
      if (!extrema.kept.empty())
        items.push_back({restyle(kHeld), fmt::format("local {} that was to stay ({} here)", name,
                                                     here(extrema.kept))});
      if (here(extrema.made) > 0)
        items.push_back(
            {restyle(kMade), fmt::format("new local {} ({} here)", name, here(extrema.made))});
    };
    if (after_.points.has_heights()) {
      if (options_.minima) add(changes_.minima, "minimum", [](auto style) { return style; });
      if (options_.maxima) add(changes_.maxima, "maximum", as_peak);
    }
    y = draw_items(svg, items, x, y) + (items.empty() ? 0 : 6);
    for (const std::string& line :
         wrapped(options_.caption, columns_of(column(1) - column(0) - 16, 13))) {
      svg.text(x, y, 13, line);
      y += 19;
    }
    return y;
  }

  double draw_sizes(Svg& svg, double x, double y,
                    const std::optional<GroundColours>& colours) const {
    draw_scale_bar(svg, frames_[0], options_.unit, x, y);
    y += 26;
    if (options_.unit == "°") {
      svg.text(x, y, 13, "x and y are degrees, drawn as if of one length");
      y += 22;
    }
    if (colours) {
      draw_height_bar(svg, *colours, options_.height_unit, x, y);
      y += 26;
    }
    const auto range = [&](std::string_view name, double low, double high) {
      svg.text(x, y, 13,
               fmt::format("{} {} to {}", name, number_within(low, low, high),
                           number_within(high, low, high)));
      y += 19;
    };
    range("x", view_.low.x, view_.high.x);
    range("y", view_.low.y, view_.high.y);
    return is_part() ? draw_small_map(svg, x, y) : y;
  }

  bool is_part() const { return count_in(view_, after_.points.xy) < after_.points.size(); }

  /// Where the window is in the terrain.
  double draw_small_map(Svg& svg, double x, double y) const {
    const Window all = widened(bounding_box(after_.points.xy));
    const double scale = kSmallMap / std::max(all.width(), all.height());
    const Frame frame{all, x, y, all.width() * scale, all.height() * scale};
    if (after_.points.has_heights() && options_.pack)
      draw_ground(svg, frame, after_, GroundColours(after_, all), options_.pack);
    svg.add(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" "
        "stroke=\"{}\" stroke-width=\"0.8\"/>\n",
        frame.left, frame.top, frame.width, frame.height, kInk);
    const Point corner = frame.pixel({view_.low.x, view_.high.y});
    const double least = 3;  // to be seen
    for (const auto& [colour, width] : {std::pair{"#ffffff", 4.0}, std::pair{"#b3261a", 2.0}})
      svg.add(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" "
          "stroke=\"{}\" stroke-width=\"{}\"/>\n",
          corner.x, corner.y, std::max(least, view_.width() * scale),
          std::max(least, view_.height() * scale), colour, width);
    svg.text(x + frame.width + 12, y + 14, 13, "the part shown,");
    svg.text(x + frame.width + 12, y + 33, 13, "in the whole");
    return y + frame.height + 14;
  }

  const Tin& before_;
  const Tin& after_;
  const PictureOptions& options_;
  Difference changes_;
  std::vector<OrderClass> classes_;
  std::vector<Edge> border_;
  Window view_;
  bool has_all_edges_ = true;
  double scale_ = 1;
  Frame frames_[2];
};

}  // namespace

Picture comparison_picture(const Tin& before, const Tin& after, const PictureOptions& options) {
  check(before, after);
  return Page(before, after, options).draw();
}

}  // namespace hodt
