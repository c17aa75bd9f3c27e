// The first order against the Delaunay triangulation that it starts from: what the optimal 1-OD
// triangulation costs beyond it, bound and verification included.
//
//   first_order_vs_delaunay [-n 1000000] [--runs 5] [--threads 1]
#include <cstdio>
#include <vector>

#include "duel.h"

#include "hodt/base/parallel.h"
#include "hodt/pipeline.h"
#include "hodt/terrain/terrain.h"

int main(int argc, char** argv) {
  const std::size_t n = duel::option(argc, argv, "-n", 1000000);
  const std::size_t runs = duel::option(argc, argv, "--runs", 5);
  const std::size_t threads = duel::option(argc, argv, "--threads", 1);
  const hodt::PointSet points = hodt::sample_terrain("valley", n, 1);
  const hodt::ThreadLimit limit(threads);
  for (const char* name :
       {"min-local-minima", "min-local-extrema", "min-sum-length", "min-max-area", "min-max-angle",
        "max-min-angle", "min-sum-flat-area", "min-sum-abn", "min-sum-jnd"}) {
    hodt::TriangulateOptions options;
    options.order = 1;
    options.objective = hodt::objective_from_name(name);
    std::vector<double> delaunay, optimize, ratio;
    for (std::size_t i = 0; i <= runs; ++i) {
      const hodt::Seconds seconds = hodt::triangulate(points, options).report.seconds;
      if (i == 0) continue;  // the first round warms up
      delaunay.push_back(seconds.delaunay);
      optimize.push_back(seconds.optimize);
      ratio.push_back(seconds.optimize / seconds.delaunay);
    }
    std::printf(
        "%s, k = 1, %zu points: delaunay %.3f s, optimize %.3f s on %zu thread(s): %.2f x\n", name,
        n, duel::median(delaunay), duel::median(optimize), threads, duel::median(ratio));
  }
}
