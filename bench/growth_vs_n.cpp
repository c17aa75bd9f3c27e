// How the time of every kind of work grows with n, on point sets that plain algorithms take
// quadratic time for, or worse: for each n the processor's seconds after the Delaunay
// triangulation (the shortest of three runs, or one if that takes long), the growth for doubled n
// (the mean ratio of two times in a row; 2 is linear), and how many times as long as uniform points
// it took for the largest n.
//
//   growth_vs_n [--smallest 10000] [--largest 80000] [--k 4] [--threads 1] [--patience 60]
//               [--only FAMILY] [--task TASK] [--time-limit SECONDS]
//
// What takes longer than --patience seconds is stopped, and printed as ">". With --time-limit the
// optimizers are asked to end by then: with --smallest and --largest 1000000 the table shows by how
// much they overrun.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "duel.h"
#include "point_sets.h"
#include <sys/resource.h>

#include "hodt/base/parallel.h"
#include "hodt/delaunay/delaunay.h"
#include "hodt/optimize/optimize.h"
#include "hodt/order/edges.h"
#include "hodt/order/triangles.h"
#include "hodt/order/triangulation_order.h"

namespace {

constexpr double kStopped = std::numeric_limits<double>::infinity();

struct Family {
  const char* name;
  std::vector<hodt::Point> (*make)(std::size_t);
};

constexpr Family kFamilies[] = {{"uniform", point_sets::uniform},
                                {"clusters", point_sets::clustered},
                                {"lattice", point_sets::lattice},
                                {"contours", point_sets::contours},
                                {"flat", point_sets::flat},
                                {"funnel", point_sets::funnel},
                                {"circle", point_sets::circle},
                                {"polygon", point_sets::polygon},
                                {"wheel", point_sets::wheel},
                                {"target", point_sets::target},
                                {"star", point_sets::star},
                                {"stars", point_sets::stars},
                                {"fan", point_sets::fan},
                                {"two hubs", point_sets::two_hubs},
                                {"parabola", point_sets::parabola},
                                {"spiral", point_sets::spiral},
                                {"two lines", point_sets::two_lines},
                                {"cross", point_sets::cross},
                                {"stretched", point_sets::stretched}};

constexpr const char* kTasks[] = {
    "edges",          "triangles",     "min-local-minima", "min-local-extrema", "min-max-degree",
    "min-sum-length", "min-max-angle", "max-min-angle",    "min-sum-abn",       "min-max-abn"};

struct Limits {
  hodt::Index k;
  std::size_t threads;
  unsigned patience;
  double time_limit;
};

/// The work itself. Of optimizing, with all that the pipeline does after the Delaunay
/// triangulation.
void work(const hodt::Delaunay& delaunay, std::string_view task, const Limits& limits) {
  const hodt::Index k = limits.k;
  hodt::DelaunayGraph graph(delaunay);
  if (task == "edges") {
    graph.list_neighbours();
    return hodt::for_each_edge(graph, hodt::EdgeClass::useful, k, [](const auto&) {});
  }
  if (task == "triangles") {
    graph.list_neighbours();
    return hodt::for_each_triangle(graph, hodt::TriangleClass::valid, k,
                                   hodt::own_numbering(graph.xy.size()), [](const auto&) {});
  }
  const hodt::Deadline deadline(limits.time_limit);
  graph.list_neighbours_if_hubs(deadline);
  const hodt::Optimum optimum =
      hodt::optimize(graph, delaunay.vertices.z, hodt::objective_from_name(std::string(task)),
                     {.order = k, .deadline = deadline});
  hodt::order_histogram(graph, optimum.change);
}

/// Of this process, by all of its threads: what others do on the machine counts little.
double processor_seconds() {
  return double(std::clock()) / CLOCKS_PER_SEC;
}

/// In a process of its own, which can be stopped.
double seconds_once(const Family& family, const char* task, std::size_t n, const Limits& limits) {
  int channel[2];
  if (pipe(channel) != 0) return kStopped;
  const pid_t child = fork();
  if (child == 0) {
    const hodt::ThreadLimit threads(limits.threads);
    const std::vector<hodt::Point> points = family.make(n);
    const hodt::Delaunay delaunay = hodt::delaunay({points, point_sets::heights(points)});
    const double before = processor_seconds();
    const auto most = static_cast<rlim_t>(before) + limits.patience;
    const rlimit patience{most, most};
    setrlimit(RLIMIT_CPU, &patience);
    work(delaunay, task, limits);
    const double taken = processor_seconds() - before;
    const bool written = write(channel[1], &taken, sizeof taken) == sizeof taken;
    _exit(written ? 0 : 1);
  }
  close(channel[1]);
  double taken = 0;
  if (read(channel[0], &taken, sizeof taken) != sizeof taken) taken = kStopped;
  close(channel[0]);
  waitpid(child, nullptr, 0);
  return taken;
}

double seconds(const Family& family, const char* task, std::size_t n, const Limits& limits) {
  constexpr double kLong = 2;
  double least = seconds_once(family, task, n, limits);
  for (int run = 1; run < 3 && least < kLong && limits.time_limit == 0; ++run)
    least = std::min(least, seconds_once(family, task, n, limits));
  return least;
}

std::string_view text_option(int argc, char** argv, std::string_view name) {
  for (int i = 1; i + 1 < argc; ++i)
    if (argv[i] == name) return argv[i + 1];
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t smallest = duel::option(argc, argv, "--smallest", 10'000);
  const std::size_t largest = duel::option(argc, argv, "--largest", 80'000);
  const Limits limits{static_cast<hodt::Index>(duel::option(argc, argv, "--k", 4)),
                      duel::option(argc, argv, "--threads", 1),
                      static_cast<unsigned>(duel::option(argc, argv, "--patience", 60)),
                      static_cast<double>(duel::option(argc, argv, "--time-limit", 0))};
  const std::string_view only = text_option(argc, argv, "--only");
  const std::string_view only_task = text_option(argc, argv, "--task");
  for (const char* task : kTasks) {
    if (!only_task.empty() && only_task != task) continue;
    std::printf("%-17s", task);
    for (std::size_t n = smallest; n <= largest; n *= 2) std::printf(" %8zu", n);
    std::printf("  growth  x uniform\n");
    double uniform = 0;
    for (const Family& family : kFamilies) {
      if (!only.empty() && only != family.name && family.make != point_sets::uniform) continue;
      std::printf("  %-15s", family.name);
      double first = 0, last = 0;
      int doublings = -1;
      for (std::size_t n = smallest; n <= largest; n *= 2) {
        last = last == kStopped ? last : seconds(family, task, n, limits);
        if (++doublings == 0) first = last;
        if (last == kStopped)
          std::printf(" %8s", ">");
        else
          std::printf(" %8.3f", last);
        std::fflush(stdout);
      }
      if (family.make == point_sets::uniform) uniform = last;
      std::printf("  %6.2f  %9.1f\n", std::pow(last / first, 1.0 / doublings), last / uniform);
      std::fflush(stdout);
    }
  }
}
