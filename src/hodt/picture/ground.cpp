#include "hodt/picture/ground.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "hodt/tin/raster.h"
#include "hodt/tin/slope.h"

namespace hodt {
namespace {

constexpr std::size_t kTrianglesOneByOne = 6000;
constexpr double kPixelsToUnit = 2;  // of an image, for whoever looks closer
constexpr Colour kPaper{253, 252, 249};

/// How the plane through a triangle rises to the east and to the north.
Point gradient(const Tin& tin, const std::array<Index, 3>& corner) {
  const auto& [a, b, c] = corner;
  const std::vector<Point>& xy = tin.points.xy;
  const std::vector<double>& z = tin.points.z;
  const Normal normal = normal_of(xy[a], xy[b], xy[c], z[a], z[b], z[c]);
  const double steepness = -normal.height / (normal.width * normal.up);
  const Point slope{steepness * normal.east, steepness * normal.north};
  return std::isfinite(slope.x) && std::isfinite(slope.y) ? slope : Point{};
}

/// What brings the usual slope to one that the lamp shows well.
double exaggeration(const Tin& tin, const Window& window) {
  std::vector<double> squares;
  for (const auto& corner : tin.triangles) {
    if (!meets(window, tin, corner)) continue;
    const Point slope = gradient(tin, corner);
    squares.push_back(slope.x * slope.x + slope.y * slope.y);
  }
  if (squares.empty()) return 1;
  const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
  std::nth_element(squares.begin(), middle, squares.end());
  return *middle > 0 ? 0.45 / std::sqrt(*middle) : 1;
}

void draw_one_by_one(Svg& svg, const Frame& frame, const Tin& tin, const GroundColours& colours) {
  std::map<Colour, std::string> paths;
  for (const auto& corner : tin.triangles) {
    if (!meets(frame.view, tin, corner)) continue;
    std::string& path = paths[colours.of(tin, corner)];
    for (int i = 0; i < 3; ++i) {
      const Point p = frame.pixel(tin.points.xy[corner[i]]);
      fmt::format_to(std::back_inserter(path), "{}{:.1f} {:.1f}", i == 0 ? 'M' : 'L', p.x, p.y);
    }
    path += 'Z';
  }
  // The thin stroke closes the hairlines between neighbours.
  svg.add("<g stroke-width=\"0.8\" stroke-linejoin=\"round\">\n");
  for (const auto& [colour, path] : paths) {
    const std::string name =
        fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue);
    svg.add("<path fill=\"{0}\" stroke=\"{0}\" d=\"{1}\"/>\n", name, path);
  }
  svg.add("</g>\n");
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= count ? letters[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

/// Numbers the colours of the triangles that the image shows; number 0 is where there is none.
Image image_of(const Tin& tin, const std::vector<Index>& triangles, const GroundColours& colours) {
  Image image;
  image.colours = {kPaper};
  image.pixels.resize(triangles.size());
  std::map<Colour, std::uint8_t> number;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (triangles[i] == kNone) continue;
    if (i > 0 && triangles[i] == triangles[i - 1]) {
      image.pixels[i] = image.pixels[i - 1];
      continue;
    }
    const Colour colour = colours.of(tin, tin.triangles[triangles[i]]);
    const auto [at, is_new] =
        number.try_emplace(colour, static_cast<std::uint8_t>(image.colours.size()));
    if (is_new) image.colours.push_back(colour);
    image.pixels[i] = at->second;
  }
  return image;
}

void draw_image(Svg& svg, const Frame& frame, const Tin& tin, const GroundColours& colours,
                const ImagePacker& pack) {
  Grid grid;
  grid.columns = static_cast<std::size_t>(std::lround(frame.width * kPixelsToUnit));
  grid.rows = static_cast<std::size_t>(std::lround(frame.height * kPixelsToUnit));
  grid.west = frame.view.low.x;
  grid.north = frame.view.high.y;
  grid.width = frame.view.width() / static_cast<double>(grid.columns);
  grid.height = frame.view.height() / static_cast<double>(grid.rows);
  std::vector<Index> triangles(grid.columns * grid.rows);
  CellTriangles(tin, grid).fill(0, triangles);
  Image image = image_of(tin, triangles, colours);
  image.width = grid.columns;
  image.height = grid.rows;
  svg.add(
      "<image x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
      "preserveAspectRatio=\"none\" href=\"data:image/png;base64,{}\"/>\n",
      frame.left, frame.top, frame.width, frame.height, base64(pack(image)));
}

}  // namespace

GroundColours::GroundColours(const Tin& tin, const Window& window)
    : lift_(exaggeration(tin, window)) {
  bool is_first = true;
  for (std::size_t vertex = 0; vertex < tin.points.size(); ++vertex) {
    if (!window.contains(tin.points.xy[vertex])) continue;
    const double z = tin.points.z[vertex];
    low_ = is_first ? z : std::min(low_, z);
    high_ = is_first ? z : std::max(high_, z);
    is_first = false;
  }
}

Colour GroundColours::of(const Tin& tin, const std::array<Index, 3>& corner) const {
  const std::vector<double>& z = tin.points.z;
  const double height = z[corner[0]] / 3 + z[corner[1]] / 3 + z[corner[2]] / 3;
  const double share = (height - low_) / (high_ - low_);
  const Point slope = gradient(tin, corner);
  return shaded(std::isfinite(share) ? share : 0.5, lift_ * slope.x, lift_ * slope.y);
}

void draw_ground(Svg& svg, const Frame& frame, const Tin& tin, const GroundColours& colours,
                 const ImagePacker& pack) {
  const auto count = std::count_if(
      tin.triangles.begin(), tin.triangles.end(),
      [&](const std::array<Index, 3>& corner) { return meets(frame.view, tin, corner); });
  if (pack && static_cast<std::size_t>(count) > kTrianglesOneByOne)
    draw_image(svg, frame, tin, colours, pack);
  else
    draw_one_by_one(svg, frame, tin, colours);
}

}  // namespace hodt
