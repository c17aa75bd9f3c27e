// Stage 2: what a raster's ties cost, and the rule that decides them. Almost free of branches: on a
// raster these go either way as if at random, and one that is guessed wrong costs more than all the
// arithmetic here.
// Tested by tests/geometry/predicates_test.cpp.
#include <bit>
#include <cstdint>

#include "hodt/geometry/pair.h"
#include "hodt/geometry/predicates.h"

namespace hodt::exact {
namespace {

/// lexicographically_less, as a mask for both lanes.
Mask less(Pair a, Pair b) {
  const Mask lt = a < b, eq = a == b;
  return first(lt) | (first(eq) & second(lt));
}

/// Whether both coordinates of p are multiples of unit, a power of two, where r = 2^52 * unit.
//
// From r on, doubles are spaced by unit or more. If |p| + r is exact, |p| is the difference of two
// multiples of unit.
Mask on_lattice(const Point& p, Pair r) {
  const Pair v = magnitude(pair(p));
  return (v + r) - r == v;
}

/// The exponent e of a positive value: 2^e <= value < 2^(e+1). For denormals something larger.
int exponent_of(double value) {
  return static_cast<int>(std::bit_cast<std::uint64_t>(value) >> 52) - 1023;
}

double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

}  // namespace

// That is so if the four x are two pairs of equal ones, and the four y too. (If they pair the same
// points, two points are equal, and the determinant is 0 as well.)
bool is_rectangle(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Pair va = pair(a), vb = pair(b), vc = pair(c), vd = pair(d);
  return all(((va == vb) & (vc == vd)) | ((va == vc) & (vb == vd)) | ((va == vd) & (vb == vc)));
}

// If all coordinates are multiples of a unit g, then all numbers of the filter are multiples of a
// power of g, and those below 2^53 times that power are exact. So let g be the least power of two
// for which the filter's bound shows that |left| + |right| <= 2^52 g². From bound < 2^(e+1) and
// bound >= 2^-51 (|left| + |right|) follows that g² >= 2^e will do. The bound also limits the
// differences: one that was rounded is 2^53 g or more, and if its product is that small, the other
// factor is 0.
int orient_lattice(Filtered f, const Point& a, const Point& b, const Point& c) {
  if (!(f.bound <= 0x1p900)) return kUndecided;
  const Pair r = both(power_of_two(52 + ((exponent_of(f.bound) + 1) >> 1)));
  if (!all(on_lattice(a, r) & on_lattice(b, r) & on_lattice(c, r))) return kUndecided;
  return (f.value > 0) - (f.value < 0);
}

int in_circle_lattice(Filtered f, const Point& a, const Point& b, const Point& c, const Point& d) {
  if (!(f.bound <= 0x1p900)) return kUndecided;
  const Pair r = both(power_of_two(52 + ((exponent_of(f.bound) + 2) >> 2)));
  if (!all(on_lattice(a, r) & on_lattice(b, r) & on_lattice(c, r) & on_lattice(d, r)))
    return kUndecided;
  return (f.value < 0) - (f.value > 0);
}

// Law (7) and law (8). Equal points need no care: if d equals the largest, it is not below it, and
// if it equals another, then orient is 0.
bool in_circle_tie(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Pair va = pair(a), vb = pair(b), vc = pair(c), vd = pair(d);
  const Mask a_over_b = less(vb, va);
  const Mask top_a = a_over_b & less(vc, va);
  const Mask top_b = ~a_over_b & less(vc, vb);
  const Mask top_c = ~(top_a | top_b);
  const Pair top = choose(top_a, va, choose(top_b, vb, vc));
  const bool raised = orient(point(choose(top_a, vd, va)), point(choose(top_b, vd, vb)),
                             point(choose(top_c, vd, vc))) > 0;
  return all(less(vd, top)) & raised;
}

// The largest is the upper right corner. If that or the corner opposite is missing in abc, then abc
// is the half that stays when the largest is raised, so d is outside: it must be left or low, not
// both.
bool rectangle_tie(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Pair va = pair(a), vb = pair(b), vc = pair(c);
  const Mask low = pair(d) < larger(larger(va, vb), vc);
  return low[0] != low[1];
}

}  // namespace hodt::exact
