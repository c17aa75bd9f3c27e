// Pages of panels, in SVG: what the figures of the gallery have in common.
// Tested by tests/CMakeLists.txt.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/geometry/point.h"

namespace gallery {

using hodt::Point;

inline constexpr double kPageWidth = 700;

/// How things look, the same in all figures, as SVG attributes.
namespace look {
inline constexpr std::string_view kDelaunay = R"(stroke="#a39b8d" stroke-width="1.2")";
inline constexpr std::string_view kFaint = R"(stroke="#ddd8ce" stroke-width="1.1")";
inline constexpr std::string_view kGone =
    R"(stroke="#c2331f" stroke-width="1.5" stroke-dasharray="5 4")";
inline constexpr std::string_view kNew = R"(stroke="#0f55a8" stroke-width="2.8")";
inline constexpr std::string_view kFixed = R"(stroke="#2b2a28" stroke-width="1.9")";
inline constexpr std::string_view kChoice =
    R"(stroke="#0f55a8" stroke-width="1.3" stroke-dasharray="4 3")";
inline constexpr std::string_view kOutline = R"(stroke="#2b2a28" stroke-width="2" fill="none")";
inline constexpr std::string_view kArc =
    R"(stroke="#7a3fa0" stroke-width="3.2" stroke-opacity="0.85")";
inline constexpr std::string_view kTriangle =
    R"(fill="#0f55a8" fill-opacity="0.16" stroke="#0f55a8" stroke-width="1.6")";
inline constexpr std::string_view kRegion = R"(fill="#f7d98a" fill-opacity="0.6" stroke="none")";
inline constexpr std::string_view kCircle =
    R"(fill="#0b8a6f" fill-opacity="0.08" stroke="#0b8a6f" stroke-width="1.6")";
inline constexpr std::string_view kOtherCircle =
    R"(fill="#d9730d" fill-opacity="0.08" stroke="#d9730d" stroke-width="1.6")";

inline constexpr std::string_view kPoint = R"(r="3.6" fill="#2b2a28")";
inline constexpr std::string_view kEnd = R"(r="5" fill="#0f55a8")";
inline constexpr std::string_view kInside =
    R"(r="5" fill="#c2331f" stroke="#ffffff" stroke-width="1")";
inline constexpr std::string_view kMinimum =
    R"(r="6" fill="#f7b52c" stroke="#2b2a28" stroke-width="1.6")";
inline constexpr std::string_view kMaximum =
    R"(r="6" fill="#ffffff" stroke="#7a3fa0" stroke-width="3")";
}  // namespace look

/// A colour for each of the orders 0 to 5, and for more.
std::string_view colour_of_order(hodt::Index order);
/// One of eight light colours for areas side by side.
std::string_view area_colour(std::size_t number);

/// A document as wide as kPageWidth.
class Page {
 public:
  Page(double height, std::string_view title);
  void add(std::string_view svg) { text_ += svg; }
  void text(double x, double y, double size, std::string_view content, std::string_view more = "");
  /// A short line in a style and what it stands for.
  void line_key(double x, double y, std::string_view style, std::string_view content);
  void dot_key(double x, double y, std::string_view style, std::string_view content);
  void area_key(double x, double y, std::string_view style, std::string_view content);
  std::string finish() &&;
  /// A number for each clipping path.
  int next_number() { return ++number_; }

 private:
  std::string text_;
  int number_ = 0;
};

struct Frame {
  double left, top, width, height;
};

/// One drawing in the plane's own coordinates, y up. Whatever the order of the calls, areas are
/// under circles, circles under lines, lines under dots, and labels on top, each at the side of its
/// point where there is most room.
class Panel {
 public:
  /// Shows all of `shown` in the frame, below a line for the title.
  Panel(Page& page, const Frame& frame, std::span<const Point> shown, std::string_view title);
  ~Panel();
  Panel(const Panel&) = delete;
  Panel& operator=(const Panel&) = delete;

  void polygon(std::span<const Point> corners, std::string_view style);
  void circle(const Point& centre, double radius, std::string_view style);
  void line(const Point& a, const Point& b, std::string_view style);
  void dot(const Point& p, std::string_view style);
  void centred(const Point& p, std::string_view text, std::string_view colour);
  void label(const Point& p, std::string_view text, std::string_view colour = "#2b2a28");

 private:
  struct Segment {
    Point a, b;
  };
  struct Label {
    Point at;
    std::string text, colour;
  };
  Point pixel(const Point& p) const;
  void place(const Label& label);
  double room(const Label& label, const Point& middle, double half_width) const;
  void write(const Label& label, const Point& middle);

  Page& page_;
  Frame frame_;
  Point middle_;
  double scale_;
  std::string areas_, circles_, lines_, dots_, texts_;
  std::vector<Segment> segments_;  // in pixels, as all below
  std::vector<Point> points_;
  std::vector<Segment> boxes_;  // low and high corner of every placed label
  std::vector<Label> labels_;
};

}  // namespace gallery
