// The main job against a plain Delaunay triangulation by CGAL, run in turn: points with heights in
// memory, a TIN of order 4 with the fewest local minima out.
//
//   job_vs_cgal [-n 1000000] [-k 4] [--runs 5] [--threads 1]
#include <cstdio>
#include <vector>

#include "cgal_route.h"
#include "duel.h"

#include "hodt/base/parallel.h"
#include "hodt/pipeline.h"
#include "hodt/terrain/terrain.h"

int main(int argc, char** argv) {
  const std::size_t n = duel::option(argc, argv, "-n", 1000000);
  const std::size_t runs = duel::option(argc, argv, "--runs", 5);
  const std::size_t threads = duel::option(argc, argv, "--threads", 1);
  hodt::TriangulateOptions options;
  options.order = static_cast<hodt::Index>(duel::option(argc, argv, "-k", 4));
  const hodt::PointSet points = hodt::sample_terrain("valley", n, 1);
  const double peak = duel::peak_bytes([&] { hodt::triangulate(points, options); });

  const hodt::ThreadLimit limit(threads);
  std::vector<double> peer, delaunay, optimize, ratio;
  hodt::Report report;
  for (std::size_t i = 0; i <= runs; ++i) {
    const double p = duel::seconds([&] { cgal_route::triangulate(points.xy); });
    report = hodt::triangulate(points, options).report;
    if (i == 0) continue;  // the first round warms up
    peer.push_back(p);
    delaunay.push_back(report.seconds.delaunay);
    optimize.push_back(report.seconds.optimize);
    ratio.push_back((report.seconds.delaunay + report.seconds.optimize) / p);
  }
  std::printf("valley, %zu points, k = %u: minima %.0f -> %.0f, bound %.0f\n", n, options.order,
              report.value->delaunay, report.value->result, report.value->bound);
  std::printf(
      "CGAL %.3f s; hodt delaunay %.3f s + optimize %.3f s on %zu thread(s): %.2f x; "
      "peak %.0f bytes a point\n",
      duel::median(peer), duel::median(delaunay), duel::median(optimize), threads,
      duel::median(ratio), peak / static_cast<double>(n));
}
