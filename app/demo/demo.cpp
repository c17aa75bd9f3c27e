// hodt_demo: the main job on real terrain, for growing orders, with a picture and a mesh to look
// at.
// Tested by tests/CMakeLists.txt.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/atomic_write.h"
#include "hodt/io/png.h"
#include "hodt/io/tin_file.h"
#include "hodt/picture/picture.h"
#include "hodt/pipeline.h"
#include "hodt/terrain/terrain.h"
#include "hodt/tin/quality.h"

namespace {

using namespace hodt;

constexpr Index kOrders[] = {0, 1, 2, 4, 8};
constexpr Index kShownOrder = 8;

Point circumcentre(const Point& a, const Point& b, const Point& c) {
  const Point u{b.x - a.x, b.y - a.y};
  const Point v{c.x - a.x, c.y - a.y};
  const double uu = u.x * u.x + u.y * u.y;
  const double vv = v.x * v.x + v.y * v.y;
  const double area = 2 * (u.x * v.y - u.y * v.x);
  return {a.x + (v.y * uu - u.y * vv) / area, a.y + (u.x * vv - v.x * uu) / area};
}

/// Of the triangles whose circumcentre lies among the points. Along the outline any triangulation
/// has slivers: three neighbours of a straight border.
double smallest_angle_inside(const Tin& tin) {
  const auto [west, east] = std::ranges::minmax(tin.points.xy, {}, &Point::x);
  const auto [south, north] = std::ranges::minmax(tin.points.xy, {}, &Point::y);
  double smallest = 180;
  for (const auto& corner : tin.triangles) {
    const Point& a = tin.points.xy[corner[0]];
    const Point& b = tin.points.xy[corner[1]];
    const Point& c = tin.points.xy[corner[2]];
    const Point centre = circumcentre(a, b, c);
    if (centre.x < west.x || centre.x > east.x || centre.y < south.y || centre.y > north.y)
      continue;
    smallest = std::min({smallest, angle_at(a, b, c), angle_at(b, c, a), angle_at(c, a, b)});
  }
  return smallest;
}

/// What the last line of the output claims, looked at once more.
void require_as_promised(const PointSet& points, const TriangulateResult& result) {
  if (result.tin.points.xy != points.xy || result.tin.points.z != points.z) {
    throw Error("the points of the result are not those of the input");
  }
  if (result.report.order > result.report.k) {
    throw Error(
        fmt::format("a triangle has order {} at k = {}", result.report.order, result.report.k));
  }
}

void print_heading() {
  fmt::print("  k   local minima   interior        bound   largest   smallest   seconds\n");
  fmt::print("      before after   after                   order    angle *\n");
}

void print_row(const TriangulateResult& result) {
  const Report& report = result.report;
  const std::string bound =
      fmt::format("{:.0f}{}", report.value->bound, report.value->optimal ? " (reached)" : "");
  fmt::print("{:>3}   {:>6} {:>5}   {:>8}   {:>10}   {:>7}   {:>7.2f}°   {:>7.3f}\n", report.k,
             report.extrema_delaunay->minima.total(), report.extrema_result->minima.total(),
             report.extrema_result->minima.interior, bound, report.order,
             smallest_angle_inside(result.tin), report.seconds.delaunay + report.seconds.optimize);
}

void write_pictures(const Tin& delaunay, const Tin& shown, const std::filesystem::path& directory) {
  std::filesystem::create_directories(directory);
  PictureOptions options;
  options.title = "Jacksboro, Tennessee";
  options.after = fmt::format("order {}", kShownOrder);
  options.caption = fmt::format(
      "New edges let water out of hollows that the Delaunay triangulation had dammed. No height is "
      "changed, and no circumcircle of a triangle holds more than {} points.",
      kShownOrder);
  options.unit = options.height_unit = "m";
  options.pack = png_of;
  const auto picture = directory / "jacksboro.svg";
  const auto mesh = directory / fmt::format("jacksboro_k{}.obj", kShownOrder);
  atomic_write(picture, comparison_picture(delaunay, shown, options).svg);
  write_tin(shown, mesh);
  fmt::print("\nWrote {} and {}\n", picture.string(), mesh.string());
}

void run(const std::filesystem::path& directory) {
  const PointSet points = sample_terrain("jacksboro", 0, 1);
  fmt::print("Jacksboro, Tennessee: {} elevation points (SRTM), as few local minima as can be\n\n",
             points.size());
  print_heading();
  Tin delaunay;
  Tin shown;
  for (const Index k : kOrders) {
    TriangulateOptions options;
    options.order = k;
    options.tell_orders = true;
    TriangulateResult result = triangulate(points, options);
    require_as_promised(points, result);
    print_row(result);
    if (k == 0) delaunay = result.tin;
    if (k == kShownOrder) shown = std::move(result.tin);
  }
  fmt::print(
      "\nNo height was changed; every triangle was verified to be of order <= k.\n"
      "* of triangles with their circumcentre inside the terrain: its outline forces slivers\n");
  write_pictures(delaunay, shown, directory);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 2) {
    fmt::print(stderr, "usage: hodt_demo [OUTPUT_DIRECTORY]   (default: demo)\n");
    return 2;
  }
  try {
    run(argc == 2 ? argv[1] : "demo");
  } catch (const std::exception& error) {
    fmt::print(stderr, "hodt_demo: {}\n", error.what());
    return 1;
  }
  return 0;
}
