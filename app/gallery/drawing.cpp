#include "drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

namespace gallery {
namespace {

constexpr double kPadding = 16;  // between what a panel shows and its frame, pixels
constexpr double kTitleHeight = 26;
constexpr double kLabelSize = 14;
constexpr std::string_view kInk = "#2b2a28";

double distance(const Point& p, const Point& q) {
  return std::hypot(p.x - q.x, p.y - q.y);
}

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point along{b.x - a.x, b.y - a.y};
  const double square = along.x * along.x + along.y * along.y;
  if (square == 0) return distance(p, a);
  const double t = ((p.x - a.x) * along.x + (p.y - a.y) * along.y) / square;
  const double s = std::clamp(t, 0.0, 1.0);
  return distance(p, {a.x + s * along.x, a.y + s * along.y});
}

double text_width(std::string_view text, double size) {
  return 0.56 * size * static_cast<double>(text.size());
}

}  // namespace

std::string_view colour_of_order(hodt::Index order) {
  static constexpr std::array<std::string_view, 7> kColours = {
      "#6b6457", "#0f55a8", "#d9730d", "#7a3fa0", "#0b8a6f", "#c2331f", "#b9b2a5"};
  return kColours[std::min<std::size_t>(order, kColours.size() - 1)];
}

std::string_view area_colour(std::size_t number) {
  static constexpr std::array<std::string_view, 8> kColours = {
      "#f7d98a", "#bcd7f0", "#cfe8c6", "#f3c6b4", "#dccbea", "#bfe5df", "#f1e3c8", "#e8c9da"};
  return kColours[number % kColours.size()];
}

Page::Page(double height, std::string_view title) {
  text_ = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\" fill=\"{2}\">\n"
      "<title>{3}</title>\n<rect width=\"{0}\" height=\"{1}\" fill=\"#fdfcf9\"/>\n",
      kPageWidth, height, kInk, title);
}

void Page::text(double x, double y, double size, std::string_view content, std::string_view more) {
  text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" {}>{}</text>\n", x, y,
                       size, more, content);
}

void Page::line_key(double x, double y, std::string_view style, std::string_view content) {
  text_ += fmt::format("<path fill=\"none\" {} d=\"M{:.1f} {:.1f}h26\"/>\n", style, x, y - 4.5);
  text(x + 33, y, 13, content);
}

void Page::dot_key(double x, double y, std::string_view style, std::string_view content) {
  text_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" {}/>\n", x + 7, y - 4.5, style);
  text(x + 19, y, 13, content);
}

void Page::area_key(double x, double y, std::string_view style, std::string_view content) {
  text_ += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"22\" height=\"13\" {}/>\n", x,
                       y - 11, style);
  text(x + 29, y, 13, content);
}

std::string Page::finish() && {
  text_ += "</svg>\n";
  return std::move(text_);
}

Panel::Panel(Page& page, const Frame& frame, std::span<const Point> shown, std::string_view title)
    : page_(page), frame_(frame) {
  page_.text(frame_.left + frame_.width / 2, frame_.top + 16, 14, title,
             R"(text-anchor="middle" font-weight="bold")");
  frame_.top += kTitleHeight;
  frame_.height -= kTitleHeight;
  const auto [west, east] = std::ranges::minmax(shown, {}, &Point::x);
  const auto [south, north] = std::ranges::minmax(shown, {}, &Point::y);
  middle_ = {(west.x + east.x) / 2, (south.y + north.y) / 2};
  scale_ = std::min((frame_.width - 2 * kPadding) / (east.x - west.x),
                    (frame_.height - 2 * kPadding) / (north.y - south.y));
}

Panel::~Panel() {
  for (const Label& label : labels_) place(label);
  const int number = page_.next_number();
  page_.add(
      fmt::format("<clipPath id=\"panel{}\"><rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
                  "height=\"{:.1f}\"/></clipPath>\n<g clip-path=\"url(#panel{})\" "
                  "stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
                  number, frame_.left, frame_.top, frame_.width, frame_.height, number));
  for (const std::string* layer : {&areas_, &circles_, &lines_, &dots_, &texts_}) page_.add(*layer);
  page_.add("</g>\n");
}

Point Panel::pixel(const Point& p) const {
  return {frame_.left + frame_.width / 2 + scale_ * (p.x - middle_.x),
          frame_.top + frame_.height / 2 - scale_ * (p.y - middle_.y)};
}

void Panel::polygon(std::span<const Point> corners, std::string_view style) {
  areas_ += fmt::format("<path {} d=\"", style);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point p = pixel(corners[i]);
    areas_ += fmt::format("{}{:.1f} {:.1f}", i == 0 ? 'M' : 'L', p.x, p.y);
  }
  areas_ += "Z\"/>\n";
}

void Panel::circle(const Point& centre, double radius, std::string_view style) {
  const Point p = pixel(centre);
  circles_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" {}/>\n", p.x, p.y,
                          scale_ * radius, style);
}

void Panel::line(const Point& a, const Point& b, std::string_view style) {
  const Point p = pixel(a), q = pixel(b);
  segments_.push_back({p, q});
  lines_ +=
      fmt::format("<path {} d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>\n", style, p.x, p.y, q.x, q.y);
}

void Panel::dot(const Point& p, std::string_view style) {
  const Point q = pixel(p);
  points_.push_back(q);
  dots_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" {}/>\n", q.x, q.y, style);
}

void Panel::label(const Point& p, std::string_view text, std::string_view colour) {
  labels_.push_back({pixel(p), std::string(text), std::string(colour)});
}

/// How far a label of that middle keeps from everything else; negative outside the frame.
double Panel::room(const Label& label, const Point& middle, double half_width) const {
  const double half_height = kLabelSize / 2;
  double least = std::min(
      {middle.x - half_width - frame_.left, frame_.left + frame_.width - middle.x - half_width,
       middle.y - half_height - frame_.top, frame_.top + frame_.height - middle.y - half_height});
  least = std::min(least, 0.0) * 10;
  double nearest = 14;
  for (const double share : {-1.0, 0.0, 1.0}) {
    const Point p{middle.x + share * (half_width - 3), middle.y};
    for (const Segment& s : segments_)
      nearest = std::min(nearest, distance_to_segment(p, s.a, s.b));
    for (const Point& q : points_)
      if (q != label.at) nearest = std::min(nearest, distance(p, q) - 9);
  }
  for (const Segment& box : boxes_) {
    const bool apart = middle.x + half_width < box.a.x || box.b.x < middle.x - half_width ||
                       middle.y + half_height < box.a.y || box.b.y < middle.y - half_height;
    if (!apart) nearest -= 100;
  }
  return least + nearest;
}

void Panel::place(const Label& label) {
  const double half_width = text_width(label.text, kLabelSize) / 2;
  double most = -std::numeric_limits<double>::infinity();
  Point best = label.at;
  for (int i = 0; i < 32; ++i) {
    const double angle = i % 16 * std::numbers::pi / 8, reach = i < 16 ? 11.5 : 15;
    const Point middle{label.at.x + std::cos(angle) * (reach + half_width - 2),
                       label.at.y - std::sin(angle) * (reach + 4)};
    const double here = room(label, middle, half_width) - (i < 16 ? 0 : 2);
    if (here <= most + 1e-9) continue;
    most = here;
    best = middle;
  }
  write(label, best);
}

void Panel::centred(const Point& p, std::string_view text, std::string_view colour) {
  write({pixel(p), std::string(text), std::string(colour)}, pixel(p));
}

void Panel::write(const Label& label, const Point& middle) {
  const double half_width = text_width(label.text, kLabelSize) / 2, half_height = kLabelSize / 2;
  boxes_.push_back({{middle.x - half_width, middle.y - half_height},
                    {middle.x + half_width, middle.y + half_height}});
  texts_ += fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" text-anchor=\"middle\" fill=\"{}\" "
      "stroke=\"#fdfcf9\" stroke-width=\"3.5\" stroke-opacity=\"0.9\" "
      "paint-order=\"stroke\">{}</text>\n",
      middle.x, middle.y + 0.36 * kLabelSize, kLabelSize, label.colour, label.text);
}

}  // namespace gallery
