// All useful edges for orders that grow with the number of points: n doubles, k is √n, n / 16 or
// n / 4, and the exponent is that of the time between two sizes. Large sets are asked from a sample
// of the vertices, spread evenly, and the time is scaled to all.
//
//   useful_edges_vs_n [--largest 4000] [--sample 1000] [--threads 0]
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "duel.h"
#include "point_sets.h"

#include "hodt/base/parallel.h"
#include "hodt/order/useful_edges.h"

namespace {

using Points = std::vector<hodt::Point>;

struct Run {
  double seconds, edges;  // of all vertices
};

Run useful_edges(const Points& points, hodt::Index k, std::size_t sample) {
  const hodt::Delaunay delaunay = hodt::delaunay({points, {}});
  const std::size_t n = delaunay.vertices.size(), asked = std::min(n, sample);
  std::atomic<std::size_t> edges = 0;
  double search = 0;
  const double all = duel::seconds([&] {
    hodt::DelaunayGraph graph(delaunay);
    graph.list_neighbours();
    hodt::UsefulEdgeSearches searches(graph, k);
    search = duel::seconds([&] {
      hodt::parallel_for(0, asked, 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
          const hodt::VertexId u(static_cast<hodt::Index>(i * n / asked));
          edges += searches.mine().to_larger(u, k).size();
        }
      });
    });
  });
  const double scale = double(n) / double(asked);
  return {all + search * (scale - 1), double(edges) * scale};
}

template <class Make, class OrderOf>
void grow(const char* set, const char* order, std::size_t largest, std::size_t sample,
          const Make& make, const OrderOf& order_of) {
  double before = 0;
  for (std::size_t n = 1000; n <= largest; n *= 2) {
    const auto k = static_cast<hodt::Index>(order_of(double(n)));
    const Run run = useful_edges(make(n), k, sample);
    std::printf("%-9s k = %-4s n = %-5zu k = %-4u %8.2f s, %6.1f useful edges a point", set, order,
                n, k, run.seconds, 3 + run.edges / double(n));
    if (before > 0) std::printf(", exponent %.2f", std::log2(run.seconds / before));
    std::printf("\n");
    std::fflush(stdout);
    before = run.seconds;
  }
}

template <class Make>
void grow_all(const char* set, std::size_t largest, std::size_t sample, const Make& make) {
  grow(set, "√n", largest, sample, make, [](double n) { return std::sqrt(n); });
  grow(set, "n/16", largest, sample, make, [](double n) { return n / 16; });
  grow(set, "n/4", largest, sample, make, [](double n) { return n / 4; });
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t largest = duel::option(argc, argv, "--largest", 4000);
  const std::size_t sample = duel::option(argc, argv, "--sample", 1000);
  const hodt::ThreadLimit limit(duel::option(argc, argv, "--threads", 0));
  grow_all("uniform", largest, sample, point_sets::uniform);
  grow_all("clustered", largest, sample, point_sets::clustered);
  grow_all("circle", largest, sample, point_sets::circle);
}
