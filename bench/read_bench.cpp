// Reading a million points, and writing a million-point mesh.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "hodt/base/parallel.h"
#include "hodt/io/point_file.h"
#include "hodt/io/tin_file.h"
#include "hodt/tin/embedding.h"
#include "hodt/tin/extrema.h"

namespace hodt {
namespace {

constexpr std::size_t kPoints = 1'000'000;

/// A file that goes with the program.
class BenchFile {
 public:
  explicit BenchFile(const std::string& name)
      : path_(std::filesystem::temp_directory_path() / ("hodt-bench-" + name)) {}
  ~BenchFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Points on the ground as surveys have them: metres with `decimals` decimals (17: all digits).
const BenchFile& table_of(int decimals) {
  static const auto make = [](int digits) {
    auto file = std::make_unique<BenchFile>(fmt::format("{}.csv", digits));
    std::mt19937_64 random(1);
    const auto next = [&](double from, double size) {
      return from + size * static_cast<double>(random() >> 11) / 9007199254740992.0;
    };
    std::string text = "x,y,z\n";
    for (std::size_t i = 0; i < kPoints; ++i) {
      const double x = next(400000, 1e5), y = next(5600000, 1e5), z = next(0, 1000);
      text += digits == 17
                  ? fmt::format("{},{},{}\n", x, y, z)
                  : fmt::format("{:.{}f},{:.{}f},{:.{}f}\n", x, digits, y, digits, z, digits);
    }
    std::ofstream(file->path(), std::ios::binary) << text;
    return file;
  };
  static const auto two = make(2), six = make(6), all = make(17);
  return decimals == 2 ? *two : decimals == 6 ? *six : *all;
}

void read_csv(benchmark::State& state) {
  const BenchFile& file = table_of(static_cast<int>(state.range(0)));
  const ThreadLimit limit(static_cast<std::size_t>(state.range(1)));
  for (auto _ : state) benchmark::DoNotOptimize(read_points(file.path()));
  state.SetBytesProcessed(state.iterations() *
                          static_cast<std::int64_t>(std::filesystem::file_size(file.path())));
}
BENCHMARK(read_csv)
    ->ArgNames({"decimals", "threads"})
    ->ArgsProduct({{2, 6, 17}, {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// A jittered 1000 x 1000 grid, two triangles a cell.
const Tin& grid() {
  static const Tin tin = [] {
    constexpr Index side = 1000;
    std::mt19937_64 random(2);
    const auto jitter = [&] {
      return 0.4 * static_cast<double>(random() >> 11) / 9007199254740992.0;
    };
    Tin grid;
    for (Index v = 0; v < side * side; ++v) {
      grid.points.xy.push_back({v % side + jitter(), v / side + jitter()});
      grid.points.z.push_back(100 * jitter());
    }
    for (Index y = 0; y + 1 < side; ++y) {
      for (Index x = 0; x + 1 < side; ++x) {
        const Index a = y * side + x, c = a + side;
        grid.triangles.push_back({a, a + 1, c + 1});
        grid.triangles.push_back({a, c + 1, c});
      }
    }
    return grid;
  }();
  return tin;
}

void write_mesh(benchmark::State& state) {
  const BenchFile file(state.range(0) ? "mesh.ply" : "mesh.obj");
  for (auto _ : state) write_tin(grid(), file.path());
}
BENCHMARK(write_mesh)->ArgName("ply")->Arg(0)->Arg(1)->UseRealTime()->Unit(benchmark::kMillisecond);

void read_mesh(benchmark::State& state) {
  const BenchFile file(state.range(0) ? "mesh.ply" : "mesh.obj");
  write_tin(grid(), file.path());
  for (auto _ : state) benchmark::DoNotOptimize(read_tin(file.path()));
}
BENCHMARK(read_mesh)->ArgName("ply")->Arg(0)->Arg(1)->UseRealTime()->Unit(benchmark::kMillisecond);

void count_extrema_of_grid(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(count_extrema(grid().points, grid().triangles));
}
BENCHMARK(count_extrema_of_grid)->Unit(benchmark::kMillisecond);

void check_embedding_of_grid(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(check_embedding(grid().points.xy, grid().triangles));
  }
}
BENCHMARK(check_embedding_of_grid)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hodt
