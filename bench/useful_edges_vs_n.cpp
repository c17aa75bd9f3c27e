// All useful edges for orders that grow with the number of points: n doubles, k is √n, n / 16 or
// n / 4, and the exponent is that of the time between two sizes.
//
//   useful_edges_vs_n [--largest 4000] [--threads 0]
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "duel.h"
#include "point_sets.h"

#include "hodt/base/parallel.h"
#include "hodt/order/edges.h"

namespace {

using Points = std::vector<hodt::Point>;

struct Run {
  double seconds;
  std::size_t edges;
};

Run useful_edges(const Points& points, hodt::Index k) {
  const hodt::Delaunay delaunay = hodt::delaunay({points, {}});
  const hodt::Numbering numbering = hodt::own_numbering(delaunay.vertices.size());
  Run run{0, 0};
  run.seconds = duel::seconds([&] {
    hodt::DelaunayGraph graph(delaunay);
    graph.list_neighbours();
    hodt::for_each_edge(
        graph, hodt::EdgeClass::useful, k, numbering,
        [&](std::span<const hodt::EdgeRecord> piece) { run.edges += piece.size(); });
  });
  return run;
}

template <class Make, class OrderOf>
void grow(const char* set, const char* order, std::size_t largest, const Make& make,
          const OrderOf& order_of) {
  double before = 0;
  for (std::size_t n = 1000; n <= largest; n *= 2) {
    const auto k = static_cast<hodt::Index>(order_of(double(n)));
    const Run run = useful_edges(make(n), k);
    std::printf("%-9s k = %-4s n = %-5zu k = %-4u %8.2f s, %6.1f edges a point", set, order, n, k,
                run.seconds, double(run.edges) / double(n));
    if (before > 0) std::printf(", exponent %.2f", std::log2(run.seconds / before));
    std::printf("\n");
    std::fflush(stdout);
    before = run.seconds;
  }
}

template <class Make>
void grow_all(const char* set, std::size_t largest, const Make& make) {
  grow(set, "√n", largest, make, [](double n) { return std::sqrt(n); });
  grow(set, "n/16", largest, make, [](double n) { return n / 16; });
  grow(set, "n/4", largest, make, [](double n) { return n / 4; });
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t largest = duel::option(argc, argv, "--largest", 4000);
  const hodt::ThreadLimit limit(duel::option(argc, argv, "--threads", 0));
  grow_all("uniform", largest, point_sets::uniform);
  grow_all("clustered", largest, point_sets::clustered);
  grow_all("circle", largest, point_sets::circle);
}
