// Sums over all triangles order by order, for uniform points in a disk, around an empty disk and in
// four disks: what a sum gains over Delaunay, whether that is proven, how long it takes, and the
// faces of more than one triangle that the fixed edges leave open.
//
//   triangle_sums_vs_k [--smallest 1000] [--largest 2000] [--first 1] [--last 10] [--step 1]
//                      [--seconds 0] [--threads 1]
//
// --seconds ends a search; 0 lets it take what it needs.
#include <algorithm>
#include <cstdio>
#include <vector>

#include "duel.h"
#include "point_sets.h"

#include "hodt/base/parallel.h"
#include "hodt/delaunay/delaunay.h"
#include "hodt/order/fixed_edges.h"
#include "hodt/pipeline.h"

namespace {

/// Faces of more than one triangle, and the triangles of the largest.
struct Faces {
  std::size_t open = 0;
  std::size_t largest = 0;
};

Faces faces_of(const hodt::PointSet& points, hodt::Index k) {
  const hodt::Delaunay delaunay = hodt::delaunay(points);
  const hodt::DelaunayGraph graph(delaunay);
  const hodt::Buffer<bool> fixed = hodt::fixed_edges(graph, k);
  const hodt::FixedFaces faces(graph, fixed);
  Faces result;
  for (hodt::Index f = 0; f < faces.size(); ++f) {
    const std::size_t size = faces.triangles(f).size();
    result.open += size > 1;
    result.largest = std::max(result.largest, size);
  }
  return result;
}

void run(const char* set, const hodt::PointSet& points, const hodt::TriangulateOptions& options) {
  const hodt::Report report = hodt::triangulate(points, options).report;
  const hodt::Value& value = *report.value;
  const Faces faces = faces_of(points, options.order);
  std::printf("%-10s %6zu %3u %12.6f %8.3f %% %12.6f  ", set, points.size(), options.order,
              value.result, 100 * (value.result - value.delaunay) / value.delaunay, value.bound);
  if (value.optimal)
    std::printf("%-12s", "proven");
  else
    std::printf("gap %6.3f %%", 100 * (value.result - value.bound) / value.result);
  std::printf(" %9.2f %7zu %8zu\n", report.seconds.optimize, faces.open, faces.largest);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t smallest = duel::option(argc, argv, "--smallest", 1000);
  const std::size_t largest = duel::option(argc, argv, "--largest", 2000);
  const std::size_t first = duel::option(argc, argv, "--first", 1);
  const std::size_t last = duel::option(argc, argv, "--last", 10);
  const std::size_t step = std::max<std::size_t>(duel::option(argc, argv, "--step", 1), 1);
  hodt::TriangulateOptions options;
  options.time_limit = double(duel::option(argc, argv, "--seconds", 0));
  const hodt::ThreadLimit limit(duel::option(argc, argv, "--threads", 1));
  const struct {
    const char* name;
    std::vector<hodt::Point> (*make)(std::size_t);
  } sets[] = {{"disk", point_sets::disk},
              {"ring", point_sets::ring},
              {"four disks", point_sets::four_disks}};
  for (const char* objective : {"min-sum-length", "max-sum-small-angle", "min-sum-inradius"}) {
    options.objective = hodt::objective_from_name(objective);
    std::printf("%s\n%-10s %6s %3s %12s %10s %12s  %-12s %9s %7s %8s\n", objective, "points", "n",
                "k", "value", "change", "bound", "proof", "seconds", "faces", "largest");
    for (const auto& set : sets)
      for (std::size_t n = smallest; n <= largest; n *= 2)
        for (std::size_t k = first; k <= last; k += step) {
          options.order = static_cast<hodt::Index>(k);
          run(set.name, {set.make(n), {}}, options);
        }
  }
}
