// Nanoseconds a call of the in-circle test, by the kind of input and so by the stage that decides.
//
// Each family is a list of quadruples a, b, c, d with a, b, c counter-clockwise.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "hodt/geometry/circle.h"
#include "hodt/geometry/predicates.h"

namespace {

using hodt::Point;
using Quad = std::array<Point, 4>;
using Random = std::mt19937_64;

constexpr std::size_t kCount = 4096;

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

std::int64_t integer(Random& random, std::int64_t low, std::int64_t high) {
  return std::uniform_int_distribution<std::int64_t>(low, high)(random);
}

/// Fills a list with what make(random) returns, a, b, c put counter-clockwise.
template <class Make>
std::vector<Quad> quads(Make make) {
  Random random(1);
  std::vector<Quad> result;
  while (result.size() < kCount) {
    Quad q = make(random);
    const int sign = hodt::orient(q[0], q[1], q[2]);
    if (sign < 0) std::swap(q[1], q[2]);
    if (sign != 0) result.push_back(q);
  }
  return result;
}

Quad random_points(Random& random) {
  Quad q;
  for (Point& p : q) p = {uniform(random, 0, 1), uniform(random, 0, 1)};
  return q;
}

/// The corners of a cell of a raster, in random order: column and row in multiples of step.
Quad cell(Random& random, double x0, double y0, double step) {
  const auto i = static_cast<double>(integer(random, 0, 999));
  const auto j = static_cast<double>(integer(random, 0, 999));
  const double x[] = {x0 + i * step, x0 + (i + 1) * step};
  const double y[] = {y0 + j * step, y0 + (j + 1) * step};
  Quad q = {Point{x[0], y[0]}, {x[1], y[0]}, {x[0], y[1]}, {x[1], y[1]}};
  std::shuffle(q.begin(), q.end(), random);
  return q;
}

Quad lattice_cell(Random& random) {
  return cell(random, 0, 0, 1);
}
Quad utm_cell(Random& random) {
  return cell(random, 412345.678, 5123456.789, 10.1);
}

/// Four of the twelve lattice points at distance 5 from a lattice point: no rectangle, as a rule.
Quad lattice_circle(Random& random, double x0, double y0, double step) {
  static constexpr int kOffset[12][2] = {{5, 0},  {4, 3},   {3, 4},   {0, 5},  {-3, 4}, {-4, 3},
                                         {-5, 0}, {-4, -3}, {-3, -4}, {0, -5}, {3, -4}, {4, -3}};
  const auto i = integer(random, 5, 999), j = integer(random, 5, 999);
  std::array<int, 12> order = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  std::shuffle(order.begin(), order.end(), random);
  Quad q;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& offset = kOffset[order[k]];
    q[k] = {x0 + static_cast<double>(i + offset[0]) * step,
            y0 + static_cast<double>(j + offset[1]) * step};
  }
  return q;
}

Quad integer_tie(Random& random) {
  return lattice_circle(random, 0, 0, 1);
}
Quad utm_tie(Random& random) {
  return lattice_circle(random, 412345, 5123456, 30);
}
/// Cocircular in decimals, but not once the coordinates are rounded to doubles.
Quad utm_decimal_circle(Random& random) {
  return lattice_circle(random, 412345.678, 5123456.789, 0.1);
}
/// Exact ties too wide for doubles: 256-bit integers decide.
Quad wide_tie(Random& random) {
  return lattice_circle(random, 412345.25, 5123456.25, 16385 + 0x1p-10 + 0x1p-20);
}
/// Exact ties beyond the range of fixed width.
Quad huge_tie(Random& random) {
  return lattice_circle(random, 0, 0, 0x1p100 + 0x1p70);
}

void set_time_per_call(benchmark::State& state) {
  using benchmark::Counter;
  state.counters["per_call"] =
      Counter(kCount, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

template <class Make>
void in_circle(benchmark::State& state, Make make) {
  const std::vector<Quad> input = quads(make);
  std::size_t inside = 0;
  for (auto _ : state)
    for (const Quad& q : input) inside += hodt::in_circle(q[0], q[1], q[2], q[3]);
  benchmark::DoNotOptimize(inside);
  set_time_per_call(state);
}

BENCHMARK_CAPTURE(in_circle, random_points, random_points);
BENCHMARK_CAPTURE(in_circle, lattice_cell, lattice_cell);
BENCHMARK_CAPTURE(in_circle, utm_cell, utm_cell);
BENCHMARK_CAPTURE(in_circle, integer_tie, integer_tie);
BENCHMARK_CAPTURE(in_circle, utm_tie, utm_tie);
BENCHMARK_CAPTURE(in_circle, utm_decimal_circle, utm_decimal_circle);
BENCHMARK_CAPTURE(in_circle, wide_tie, wide_tie);
BENCHMARK_CAPTURE(in_circle, huge_tie, huge_tie);

/// 256-bit integers without the stages before.
void in_circle_fixed(benchmark::State& state) {
  const std::vector<Quad> input = quads(wide_tie);
  int sum = 0;
  for (auto _ : state)
    for (const Quad& q : input) sum += hodt::exact::in_circle_fixed(q[0], q[1], q[2], q[3]);
  benchmark::DoNotOptimize(sum);
  set_time_per_call(state);
}
BENCHMARK(in_circle_fixed);

void orient(benchmark::State& state) {
  const std::vector<Quad> input = quads(random_points);
  int sum = 0;
  for (auto _ : state)
    for (const Quad& q : input) sum += hodt::orient(q[0], q[1], q[3]);
  benchmark::DoNotOptimize(sum);
  set_time_per_call(state);
}
BENCHMARK(orient);

/// One circle asked about many points.
void circle_contains(benchmark::State& state) {
  const std::vector<Quad> input = quads(random_points);
  const hodt::Circle circle(input[0][0], input[0][1], input[0][2]);
  std::size_t inside = 0;
  for (auto _ : state)
    for (const Quad& q : input) inside += circle.contains(q[3]);
  benchmark::DoNotOptimize(inside);
  set_time_per_call(state);
}
BENCHMARK(circle_contains);

}  // namespace
