// Families of test point sets and heights: the shapes on which triangulations go wrong.
//
// All are deterministic: the same (n, seed) gives the same points, on any machine with the same
// sin, cos and pow. A family gives n >= 4 different points where it can, fewer where it has no
// more, and never only points of one line. Nothing here uses hodt.
#pragma once

#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace families {

using Points = std::vector<std::pair<double, double>>;
using Heights = std::vector<double>;

/// A small generator whose numbers are the same everywhere (std distributions are not).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u + 1) {}
  std::uint64_t bits();
  /// Uniform in [0, 1), with 53 bits.
  double real();
  double real(double low, double high) { return low + (high - low) * real(); }
  /// Uniform in [low, high].
  int integer(int low, int high);
  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[bits() % i]);
  }

 private:
  std::uint64_t state_;
};

// General position, mostly.
Points random_square(int n, std::uint64_t seed);
Points clusters(int n, std::uint64_t seed);
Points convex_parabola(int n, std::uint64_t seed);
Points convex_ellipse(int n, std::uint64_t seed);
/// A hub in the middle of a circle of n - 1 rounded points: one vertex of degree n - 1.
Points star(int n, std::uint64_t seed);

// Ties by the dozen: collinear triples, cocircular quadruples, exact.
Points lattice(int columns, int rows);
/// A random n-subset of a side × side lattice.
Points lattice_subset(int n, std::uint64_t seed, int side);
/// Integer points on one circle: n of the up to 64 on x² + y² = radius_squared.
Points ring(int n, std::uint64_t seed, int radius_squared = 32045, bool with_centre = false);
/// Integer points on circles about one centre.
Points concentric_rings(int n, std::uint64_t seed);
/// Most points on one line, inside the hull or as a side of it.
Points collinear_inside(int n, std::uint64_t seed);
Points collinear_on_hull(int n, std::uint64_t seed);
/// All but one point on a line: every triangle has the same apex.
Points fan(int n, std::uint64_t seed);
/// A rectangle's outline with points on its sides.
Points outline(int n, std::uint64_t seed);
Points two_lines(int n, std::uint64_t seed);
/// A hexagonal arrangement, which doubles cannot hold exactly: nearly cocircular.
Points hexagonal(int n, std::uint64_t seed);

// Hard on arithmetic.
/// A ring with every coordinate moved by up to two units in the last place.
Points nearly_cocircular(int n, std::uint64_t seed);
/// A line of slope 1/3, rounded: turns of an ulp both ways. With two points off it.
Points nearly_collinear(int n, std::uint64_t seed);
/// A lattice subset with noise of 1e-15 on some coordinates.
Points noisy_lattice(int n, std::uint64_t seed);
/// A lattice of step 1e-3 at (1e7, 2e7): the coordinates are rounded, the ties are not exact.
Points huge_offset(int n, std::uint64_t seed);
/// Pairs and triples of points an ulp apart.
Points tiny_gaps(int n, std::uint64_t seed);
/// Coordinates of every magnitude from 1e-300 to 1e300, and zero.
Points wide_range(int n, std::uint64_t seed);
/// A lattice of step 2^-1074: subnormal coordinates.
Points subnormal_lattice(int n, std::uint64_t seed);

// Heights of given points.
Heights random_heights(const Points& points, std::uint64_t seed);
/// Integers from 0 to 2: mostly ties.
Heights few_heights(const Points& points, std::uint64_t seed);
Heights equal_heights(const Points& points, std::uint64_t seed);
Heights sloped_plane(const Points& points, std::uint64_t seed);
/// A random permutation of 0 ... n - 1.
Heights permutation_heights(const Points& points, std::uint64_t seed);

struct Family {
  std::string name;
  std::function<Points(int n, std::uint64_t seed)> make;
};

/// The name that GoogleTest gives a test of this family.
inline void PrintTo(const Family& family, std::ostream* out) {
  *out << family.name;
}

struct HeightFamily {
  std::string name;
  std::function<Heights(const Points& points, std::uint64_t seed)> make;
};

/// Every family above, parameters filled in.
const std::vector<Family>& all();
const std::vector<HeightFamily>& all_heights();

}  // namespace families
