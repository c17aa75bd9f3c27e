// The constrained Delaunay triangulation against our plain one of the same points, and against
// CGAL's by its fastest documented route, run in turn; and what walls cost the rest of the job.
//
//   constrained_vs_cgal [-n 1000000] [--edges 100000] [--runs 5] [--threads 1]
//
// Both sides start from coordinates in input order and pairs of rows, and end with their mesh.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <utility>
#include <vector>

#include "constraint_sets.h"
#include "duel.h"
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "hodt/base/parallel.h"
#include "hodt/order/edges.h"
#include "hodt/pipeline.h"
#include "hodt/pipeline/constrain.h"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Cgal = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Default,
                                                        CGAL::No_constraint_intersection_tag>;
using Set = constraint_sets::Set;

/// For CGAL, in its own types.
struct CgalInput {
  explicit CgalInput(const Set& set) {
    for (const hodt::Point& p : set.points.xy) points.emplace_back(p.x, p.y);
    for (const auto& [a, b] : set.edges) edges.emplace_back(a, b);
  }
  Cgal triangulate() const {
    Cgal t;
    t.insert_constraints(points.begin(), points.end(), edges.begin(), edges.end());
    return t;
  }
  std::vector<Kernel::Point_2> points;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
};

hodt::Constraints constraints_of(const Set& set) {
  hodt::Constraints constraints;
  constraints.edges = set.edges;
  return constraints;
}

hodt::Delaunay constrained(const Set& set) {
  hodt::Delaunay delaunay = hodt::delaunay(set.points);
  hodt::constrain(delaunay, set.points, constraints_of(set));
  return delaunay;
}

/// Times of something with walls, and ratios to the same without.
class Ratio {
 public:
  void add(double with, double without) {
    with_.push_back(with);
    without_.push_back(without);
    ratio_.push_back(with / without);
  }
  void print(const char* what, const char* other) const {
    std::printf("  %-36s %.3f s, %s %.3f s: %.2f x\n", what, duel::median(with_), other,
                duel::median(without_), duel::median(ratio_));
    std::fflush(stdout);
  }

 private:
  std::vector<double> with_, without_, ratio_;
};

void check_same_size(const Set& set, const hodt::Delaunay& ours) {
  const Cgal theirs = CgalInput(set).triangulate();
  std::size_t walls = 0;
  for (hodt::Index i = 0; i < ours.mesh.halfedge_count(); ++i) {
    const hodt::HalfEdgeId h(i);
    walls += ours.walls[h] && (ours.mesh.is_boundary(h) || h < ours.mesh.twin(h));
  }
  const auto constrained = static_cast<std::size_t>(
      std::distance(theirs.constrained_edges_begin(), theirs.constrained_edges_end()));
  std::printf("  %zu triangles, %zu constrained edges\n", ours.mesh.triangle_count(), walls);
  if (theirs.number_of_faces() == ours.mesh.triangle_count() && constrained == walls) return;
  std::printf("  CGAL has %zu and %zu\n", std::size_t(theirs.number_of_faces()), constrained);
  std::exit(1);
}

void triangulate_in_turn(const Set& set, std::size_t runs) {
  const CgalInput input(set);
  Ratio to_plain, to_cgal;
  for (std::size_t i = 0; i <= runs; ++i) {
    const double ours = duel::seconds([&] { constrained(set); });
    const double plain = duel::seconds([&] { hodt::delaunay(set.points); });
    const double cgal = duel::seconds([&] { input.triangulate(); });
    if (i == 0) continue;  // the first round warms up
    to_plain.add(ours, plain);
    to_cgal.add(ours, cgal);
  }
  to_plain.print("constrained Delaunay triangulation", "plain");
  to_cgal.print("constrained Delaunay triangulation", "CGAL's");
}

void do_the_job_in_turn(const Set& set, std::size_t runs) {
  const hodt::TriangulateOptions options{.order = 4};
  const auto seconds = [&](const hodt::Constraints& constraints) {
    const hodt::Seconds parts = hodt::triangulate(set.points, options, constraints).report.seconds;
    return parts.delaunay + parts.optimize;
  };
  Ratio ratio;
  for (std::size_t i = 0; i < runs; ++i) {
    const double with = seconds(constraints_of(set)), without = seconds({});
    ratio.add(with, without);
  }
  ratio.print("fewest minima at k = 4", "without");
}

void list_edges_in_turn(const Set& set, std::size_t runs) {
  const hodt::Delaunay plain = hodt::delaunay(set.points), walls = constrained(set);
  const auto seconds = [](const hodt::Delaunay& delaunay, hodt::Index k) {
    return duel::seconds([&] {
      hodt::DelaunayGraph graph(delaunay);
      graph.list_neighbours();
      hodt::for_each_edge(graph, hodt::EdgeClass::useful, k, [](const auto&) {});
    });
  };
  for (const hodt::Index k : {4, 8}) {
    Ratio ratio;
    for (std::size_t i = 0; i < runs; ++i) {
      const double with = seconds(walls, k);
      ratio.add(with, seconds(plain, k));
    }
    ratio.print(k == 4 ? "useful edges at k = 4" : "useful edges at k = 8", "without");
  }
}

void run(const char* name, const Set& set, std::size_t runs) {
  std::printf("%s: %zu points, %zu edges\n", name, set.points.size(), set.edges.size());
  check_same_size(set, constrained(set));
  triangulate_in_turn(set, runs);
  do_the_job_in_turn(set, runs);
  list_edges_in_turn(set, std::min<std::size_t>(runs, 3));
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t n = duel::option(argc, argv, "-n", 1000000);
  const std::size_t edges = duel::option(argc, argv, "--edges", 100000);
  const std::size_t runs = duel::option(argc, argv, "--runs", 5);
  const hodt::ThreadLimit limit(duel::option(argc, argv, "--threads", 1));
  run("disjoint segments", constraint_sets::segments(n, edges), runs);
  run("contours", constraint_sets::contours(n, edges), runs);
}
