// Sums across edges on the terrain `valley`: how many Delaunay triangulations long the optimizer
// takes, what it gains over Delaunay and how far the bound is, and the memory that the whole job
// takes beside its input, per point.
//
//   across_edges_vs_n [--smallest 100000] [--largest 1000000] [--threads 2] [--exact 0]
//
// For n from the smallest to the largest, ten times as many each time, and k = 4 and 8.
#include <cstdio>

#include "duel.h"

#include "hodt/base/parallel.h"
#include "hodt/pipeline.h"
#include "hodt/terrain/terrain.h"

namespace {

void run(const char* objective, const hodt::PointSet& points,
         const hodt::TriangulateOptions& options) {
  hodt::Report report;
  report = hodt::triangulate(points, options).report;
  const double bytes = duel::peak_bytes([&] { hodt::triangulate(points, options); });
  const hodt::Value& value = *report.value;
  std::printf("%-12s %9zu %2u %8.2f %9.2f %7.1f %8.2f %% %8.2f %% %8.0f\n", objective,
              points.size(), options.order, report.seconds.delaunay, report.seconds.optimize,
              report.seconds.optimize / report.seconds.delaunay,
              100 * (value.result - value.delaunay) / value.delaunay,
              100 * (value.result - value.bound) / value.result, bytes / double(points.size()));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t smallest = duel::option(argc, argv, "--smallest", 100'000);
  const std::size_t largest = duel::option(argc, argv, "--largest", 1'000'000);
  hodt::TriangulateOptions options;
  if (duel::option(argc, argv, "--exact", 0) != 0) options.method = hodt::Method::exact;
  const hodt::ThreadLimit limit(duel::option(argc, argv, "--threads", 2));
  std::printf("%-12s %9s %2s %8s %9s %7s %10s %10s %8s\n", "objective", "n", "k", "Delaunay",
              "optimize", "ratio", "change", "gap", "B/point");
  for (std::size_t n = smallest; n <= largest; n *= 10) {
    const hodt::PointSet points = hodt::sample_terrain("valley", n, 1);
    for (const char* objective : {"min-sum-abn", "min-sum-jnd", "min-sum-wabn"})
      for (const hodt::Index k : {4u, 8u}) {
        options.objective = hodt::objective_from_name(objective);
        options.order = k;
        run(objective, points, options);
      }
  }
}
