// The Delaunay triangulation alone: the component delaunay.
#include "hodt/delaunay/delaunay.h"

#include <cstdio>
#include <string_view>

static_assert(std::string_view(OPTIONS) == "-ffp-contract=off",
              "hodt imposes other options: " OPTIONS);

int main() {
  hodt::PointSet points;
  for (int row = 0; row < 10; ++row)
    for (int column = 0; column < 10; ++column) points.xy.push_back({double(column), double(row)});
  const hodt::Delaunay delaunay = hodt::delaunay(points);
  std::printf("%zu triangles\n", delaunay.mesh.triangle_count());
  return delaunay.mesh.triangle_count() == 2 * 9 * 9 ? 0 : 1;
}
