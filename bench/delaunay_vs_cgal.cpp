// Our Delaunay triangulation against CGAL's best route to flat arrays, run in turn.
//
//   delaunay_vs_cgal [-n 1000000] [--runs 5]
//
// Both sides start from coordinates in input order and end with the triangles and neighbours in
// input numbering (cgal_route.h says how CGAL gets there).
#include <cstdio>
#include <vector>

#include "cgal_route.h"
#include "duel.h"
#include "point_sets.h"

#include "hodt/base/parallel.h"
#include "hodt/delaunay/delaunay.h"

namespace {

void run(const char* name, std::vector<hodt::Point> points, std::size_t runs) {
  const hodt::PointSet set{std::move(points), {}};
  const auto ours = [&](std::size_t threads) {
    const hodt::ThreadLimit limit(threads);
    hodt::Delaunay d = hodt::delaunay(set);
    return hodt::in_input_numbering(std::move(d.mesh), d.vertices, set.size());
  };
  // Memory first: a child starts with what its parent holds, freed or not.
  const double peak = duel::peak_bytes([&] { ours(1); });
  const double cgal_peak = duel::peak_bytes([&] { cgal_route::triangulate(set.xy); });
  std::vector<double> peer, one, two, ratio_one, ratio_two;
  for (std::size_t i = 0; i <= runs; ++i) {
    const double p = duel::seconds([&] { cgal_route::triangulate(set.xy); });
    const double a = duel::seconds([&] { ours(1); });
    const double b = duel::seconds([&] { ours(2); });
    if (i == 0) continue;  // the first round warms up
    peer.push_back(p);
    one.push_back(a);
    two.push_back(b);
    ratio_one.push_back(a / p);
    ratio_two.push_back(b / p);
  }
  const double n = static_cast<double>(set.size());
  std::printf(
      "%-8s %9zu points: CGAL %.3f s, hodt %.3f s on one thread (%.2f x), %.3f s on two "
      "(%.2f x); peak bytes a point: CGAL %.0f, hodt %.0f\n",
      name, set.size(), duel::median(peer), duel::median(one), duel::median(ratio_one),
      duel::median(two), duel::median(ratio_two), cgal_peak / n, peak / n);
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t n = duel::option(argc, argv, "-n", 1000000);
  const std::size_t runs = duel::option(argc, argv, "--runs", 5);
  run("uniform", point_sets::uniform(n), runs);
  run("lattice", point_sets::lattice(n), runs);
}
