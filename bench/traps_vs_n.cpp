// All useful edges of point sets that plain searches take quadratic time for, or worse: n doubles,
// and the time a point should stay the same.
//
//   traps_vs_n [--largest 16000] [--threads 1]
#include <cstdio>
#include <string>
#include <vector>

#include "duel.h"
#include "point_sets.h"

#include "hodt/base/parallel.h"
#include "hodt/order/edges.h"

namespace {

using Points = std::vector<hodt::Point>;

template <class Make>
void grow(const std::string& name, std::size_t largest, const Make& make) {
  for (const hodt::Index k : {4, 8, 20})
    for (std::size_t n = 1000; n <= largest; n *= 4) {
      const hodt::Delaunay delaunay = hodt::delaunay({make(n), {}});
      std::size_t edges = 0;
      const double seconds = duel::seconds([&] {
        hodt::DelaunayGraph graph(delaunay);
        graph.list_neighbours();
        hodt::for_each_edge(
            graph, hodt::EdgeClass::useful, k,
            [&](std::span<const hodt::EdgeRecord> piece) { edges += piece.size(); });
      });
      std::printf("%-8s k = %-2u n = %-5zu %7.3f s, %6.1f us a point, %.3f edges a point\n",
                  name.c_str(), k, n, seconds, 1e6 * seconds / double(n),
                  double(edges) / double(n));
      std::fflush(stdout);
    }
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t largest = duel::option(argc, argv, "--largest", 16000);
  const hodt::ThreadLimit limit(duel::option(argc, argv, "--threads", 1));
  grow("polygon", largest, point_sets::polygon);
  grow("wheel", largest, point_sets::wheel);
  grow("star", largest, point_sets::star);
}
