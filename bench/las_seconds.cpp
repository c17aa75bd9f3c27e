// Reads all points of a LAS or LAZ file and prints the seconds that passed, and those of all cores.
#include <cstdio>
#include <ctime>

#include "hodt/base/stopwatch.h"
#include "hodt/io/las/las_reader.h"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  hodt::Stopwatch watch;
  const hodt::LasPoints las =
      hodt::read_las(hodt::read_input(argv[1]), hodt::parse_las_choice("all", ""));
  const double cores = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  std::printf("%.3f %.3f\n", watch.lap(), cores);
  return las.points.size() > 0 ? 0 : 1;
}
