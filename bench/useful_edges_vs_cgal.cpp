// All useful edges up to order k, the Delaunay triangulation given, against CGAL's plain range
// insertion of the same points, run in turn.
//
//   useful_edges_vs_cgal [-n 1000000] [--runs 3] [--threads 1]
#include <cstdio>
#include <string>
#include <vector>

#include "cgal_route.h"
#include "duel.h"
#include "point_sets.h"

#include "hodt/base/parallel.h"
#include "hodt/order/edges.h"

namespace {

using Points = std::vector<hodt::Point>;

double cgal_seconds(const Points& points) {
  std::vector<cgal_route::Kernel::Point_2> input;
  for (const hodt::Point& p : points) input.emplace_back(p.x, p.y);
  return duel::seconds([&] {
    CGAL::Delaunay_triangulation_2<cgal_route::Kernel> t;
    t.insert(input.begin(), input.end());
  });
}

void run(const std::string& name, const Points& points, std::size_t runs) {
  const hodt::Delaunay delaunay = hodt::delaunay({points, {}});
  for (const hodt::Index k : {1, 2, 4, 8}) {
    std::vector<double> seconds, ratios;
    std::size_t edges = 0;
    for (std::size_t i = 0; i < runs; ++i) {
      const double peer = cgal_seconds(points);
      edges = 0;
      seconds.push_back(duel::seconds([&] {
        hodt::DelaunayGraph graph(delaunay);
        if (k > 1) graph.list_neighbours();
        hodt::for_each_edge(
            graph, hodt::EdgeClass::useful, k,
            [&](std::span<const hodt::EdgeRecord> piece) { edges += piece.size(); });
      }));
      ratios.push_back(seconds.back() / peer);
    }
    std::printf("%-9s k = %u: %.3f edges a point, %.3f us a point, %.2f x CGAL\n", name.c_str(), k,
                double(edges) / double(points.size()),
                1e6 * duel::median(seconds) / double(points.size()), duel::median(ratios));
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t n = duel::option(argc, argv, "-n", 1000000);
  const std::size_t runs = duel::option(argc, argv, "--runs", 3);
  const hodt::ThreadLimit limit(duel::option(argc, argv, "--threads", 1));
  run("uniform", point_sets::uniform(n), runs);
  run("lattice", point_sets::lattice(n), runs);
  run("clustered", point_sets::clustered(n), runs);
}
