#include "app/comparison_chart.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "hodt/picture/markup.h"

namespace hodt::app {

namespace {

// In pixels: the whole chart, and the plot in it.
constexpr double kWidth = 760;
constexpr double kHeight = 300;
constexpr double kLeft = 92;
constexpr double kRight = 744;
constexpr double kTop = 36;
constexpr double kBottom = 256;

constexpr std::string_view kValueColour = "#0f55a8";
constexpr std::string_view kBoundColour = "#c2631f";

struct Range {
  double low = 0;
  double high = 0;
};

/// 1, 2 or 5 times a power of ten, so that about five steps fill the range.
double nice_step(const Range& range) {
  const double rough = (range.high - range.low) / 5;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= rough) return factor * power;
  return 10 * power;
}

class Chart {
 public:
  explicit Chart(const ObjectiveComparison& objective) : objective_(objective) {}

  std::string draw() && {
    find_ranges();
    add("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n", kWidth, kHeight,
        escaped(name_of(objective_.objective()) + ": value and bound against k"));
    if (drawable_) {
      draw_value_axis();
      draw_order_axis();
      draw_line(&Value::bound, kBoundColour, " stroke-dasharray=\"6 4\"");
      draw_line(&Value::result, kValueColour, "");
      draw_points();
      draw_legend();
    } else {
      add("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">no finite value to draw</text>\n",
          kWidth / 2, kHeight / 2);
    }
    text_ += "</svg>\n";
    return std::move(text_);
  }

 private:
  template <class... Args>
  void add(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
  }

  void find_ranges() {
    for (const ComparisonRow& row : objective_.rows)
      for (const double value : {row.value.result, row.value.bound}) include(row.k, value);
    widen_to_steps();
    if (orders_.low == orders_.high) orders_.high += 1;
  }

  void include(Index k, double value) {
    if (!std::isfinite(value)) return;
    if (!drawable_) {
      orders_ = {double(k), double(k)};
      values_ = {value, value};
      drawable_ = true;
    }
    orders_ = {std::min(orders_.low, double(k)), std::max(orders_.high, double(k))};
    values_ = {std::min(values_.low, value), std::max(values_.high, value)};
  }

  /// From one line of the grid to another, with room between even if all values are equal.
  void widen_to_steps() {
    constexpr double rounding = 1e-9;
    const double size = std::max(std::fabs(values_.low), std::fabs(values_.high));
    if (values_.high - values_.low <= rounding * size) {
      const double room = size > 0 ? size / 20 : 1;
      values_ = {values_.low - room, values_.high + room};
    }
    step_ = nice_step(values_);
    values_ = {step_ * std::floor(values_.low / step_ + rounding),
               step_ * std::ceil(values_.high / step_ - rounding)};
    drawable_ = drawable_ && std::isfinite(values_.high - values_.low);
  }

  double x(double k) const {
    return kLeft + (kRight - kLeft) * (k - orders_.low) / (orders_.high - orders_.low);
  }
  double y(double value) const {
    return kBottom - (kBottom - kTop) * (value - values_.low) / (values_.high - values_.low);
  }

  void draw_value_axis() {
    const auto lines = std::lround((values_.high - values_.low) / step_);
    for (long i = 0; i <= lines; ++i) {
      double value = values_.low + step_ * double(i);
      if (std::fabs(value) < step_ / 2) value = 0;
      add("<path class=\"grid\" d=\"M{} {:.1f}H{}\"/>\n", kLeft, y(value), kRight);
      add("<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{:.8g}</text>\n", kLeft - 10,
          y(value) + 4, value);
    }
  }

  /// A tick for each order, a number where there is room.
  void draw_order_axis() {
    add("<path class=\"axis\" d=\"M{} {}H{}\"/>\n", kLeft, kBottom, kRight);
    constexpr double room = 26;
    double last = kLeft - room;
    for (const ComparisonRow& row : objective_.rows) {
      const double at = x(row.k);
      add("<path class=\"axis\" d=\"M{:.1f} {}v5\"/>\n", at, kBottom);
      if (at - last < room) continue;
      add("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", at, kBottom + 21,
          row.k);
      last = at;
    }
    add("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">order k</text>\n", (kLeft + kRight) / 2,
        kBottom + 40);
  }

  void draw_line(double Value::*member, std::string_view colour, std::string_view style) {
    std::string path;
    for (const ComparisonRow& row : objective_.rows) {
      const double value = row.value.*member;
      if (!std::isfinite(value)) continue;
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x(row.k), y(value));
    }
    if (path.empty()) return;
    add("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{}/>\n", path, colour, style);
  }

  /// Filled where the value is proved best.
  void draw_points() {
    for (const ComparisonRow& row : objective_.rows) {
      if (!std::isfinite(row.value.result)) continue;
      add("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"{}\" stroke=\"{}\" "
          "stroke-width=\"2\"><title>k = {}: {:.8g}, bound {:.8g}</title></circle>\n",
          x(row.k), y(row.value.result), row.value.optimal ? kValueColour : "#ffffff", kValueColour,
          row.k, row.value.result, row.value.bound);
    }
  }

  void draw_legend() {
    constexpr double line = 12, next = 96;
    add("<path d=\"M{} {}h26\" stroke=\"{}\" stroke-width=\"2\"/>\n", kLeft, line, kValueColour);
    add("<text x=\"{}\" y=\"{}\">value</text>\n", kLeft + 33, line + 4);
    add("<path d=\"M{} {}h26\" stroke=\"{}\" stroke-width=\"2\" stroke-dasharray=\"6 4\"/>\n",
        kLeft + next, line, kBoundColour);
    add("<text x=\"{}\" y=\"{}\">bound</text>\n", kLeft + next + 33, line + 4);
    add("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">filled points: proved best</text>\n", kRight,
        line + 4);
  }

  const ObjectiveComparison& objective_;
  bool drawable_ = false;
  Range orders_;
  Range values_;
  double step_ = 1;
  std::string text_;
};

}  // namespace

std::string comparison_chart(const ObjectiveComparison& objective) {
  return Chart(objective).draw();
}

}  // namespace hodt::app
