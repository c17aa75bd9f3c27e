#include "hodt/order/search/pencil.h"

#include <algorithm>
#include <bit>

#include "hodt/geometry/predicates.h"

namespace hodt {

namespace {

/// Calls f(index) for the set bits of a mask, until it returns false.
template <class Word, class F>
bool all_of(std::size_t words, const Word& word, const F& f) {
  for (std::size_t i = 0; i < words; ++i)
    for (std::uint64_t rest = word(i); rest != 0; rest &= rest - 1)
      if (!f(static_cast<Index>(64 * i + std::size_t(std::countr_zero(rest))))) return false;
  return true;
}

}  // namespace

/// +1 if p is to the left of u -> i, -1 to the right, 0 on the line.
int Pencil::side_of(Index i, Index p) const {
  return orient(around_.graph().point(around_.centre()), around_.point(i), around_.point(p));
}

/// Whether p, a point of the line, lies between u and i.
bool Pencil::is_between(Index i, Index p) const {
  const Point &u = around_.graph().point(around_.centre()), &v = around_.point(i);
  const Point& q = around_.point(p);
  return lexicographically_less(u, q) ? lexicographically_less(q, v) : lexicographically_less(v, q);
}

/// Whether the circle through u, i and `first`, on that side of u -> i, holds p.
bool Pencil::is_inside(Index i, Index first, Side side, Index p) const {
  const Point &u = around_.graph().point(around_.centre()), &v = around_.point(i);
  const Point &s = around_.point(first), &q = around_.point(p);
  return side == Side::left ? in_circle(u, v, s, q) : in_circle(v, u, s, q);
}

/// Lemma 4. In the neighbourhood the first points are found if the order is within the limit; if
/// it is not, neither is what comes out (docs/design/useful-edges.md).
Index Pencil::useful_order(Index i, Index limit) {
  if (!around_.points().usable()) return useful_order_exactly(i, limit);
  if (around_.points().surely_beyond(i, limit)) return limit + 1;
  const LocalPoints::Firsts firsts = around_.points().guess_firsts(i);
  if (firsts.left == kNone) return useful_order_exactly(i, limit);
  Index order = 0;
  for (const Side side : {Side::left, Side::right}) {
    const Index count =
        count_beyond(i, side == Side::left ? firsts.left : firsts.right, side, limit);
    if (count == kUnclear) return useful_order_exactly(i, limit);
    if (count > limit) return limit + 1;
    order = std::max(order, count);
  }
  return order;
}

/// The points inside the circle through u, i and the first point on a side, all of them beyond
/// u i. `first` is a guess: others that rounding puts on the circle may come before it.
Index Pencil::count_beyond(Index i, Index first, Side side, Index limit) {
  const int sign = side == Side::left ? 1 : -1;
  if (side_of(i, first) != sign) return kUnclear;
  for (;;) {
    if (side == Side::left)
      around_.points().split(i, first, LocalPoints::Beyond::right_of_b, split_);
    else
      around_.points().split(first, i, LocalPoints::Beyond::left_of_c, split_);
    const std::size_t words = split_.size();

    // What is inside without being beyond: a point of the segment, or the guess was wrong.
    bool on_segment = false;
    const bool beyond = all_of(
        words, [&](std::size_t w) { return split_[w].inside & ~split_[w].beyond; },
        [&](Index p) {
          const int s = side_of(i, p);
          on_segment |= s == 0;
          return s == -sign;
        });
    if (!beyond) return on_segment ? kNoEdge : kUnclear;

    Index count = 0;
    for (const auto& split : split_) count += static_cast<Index>(std::popcount(split.inside));
    if (count > limit) return limit + 1;

    Index earlier = first;
    const auto doubtful = [&](std::size_t w) { return split_[w].doubtful; };
    const bool is_edge = all_of(words, doubtful, [&](Index p) {
      if (p == i || p == first) return true;
      const int s = side_of(i, p);
      if (s == sign && is_inside(i, earlier, side, p)) earlier = p;
      return s != 0 || !is_between(i, p);
    });
    if (!is_edge) return kNoEdge;
    if (earlier == first) {
      all_of(words, doubtful, [&](Index p) {
        count += p != i && p != first && side_of(i, p) == -sign && is_inside(i, first, side, p);
        return true;
      });
      return count;
    }
    first = earlier;
  }
}

Index Pencil::useful_order_exactly(Index i, Index limit) const {
  Index left = kNone, right = kNone;
  for (Index p = 0; p < around_.size(); ++p) {
    if (p == i) continue;
    const int s = side_of(i, p);
    if (s == 0 && is_between(i, p)) return limit + 1;
    if (s > 0 && (left == kNone || is_inside(i, left, Side::left, p))) left = p;
    if (s < 0 && (right == kNone || is_inside(i, right, Side::right, p))) right = p;
  }
  if (left == kNone || right == kNone) return limit + 1;
  Index in_left = 0, in_right = 0;
  for (Index p = 0; p < around_.size() && std::max(in_left, in_right) <= limit; ++p) {
    in_left += is_inside(i, left, Side::left, p);
    in_right += is_inside(i, right, Side::right, p);
  }
  return std::min(std::max(in_left, in_right), limit + 1);
}

Index Pencil::edge_order(Index i, Index limit) {
  if (i < around_.degree()) return 0;
  put_in_order(i);
  return between_count_ > 0 ? limit + 1 : std::min(fewest_inside(), limit + 1);
}

Index Pencil::least_order(Index i, std::size_t sample) {
  put_in_order(i, sample);
  return fewest_inside();
}

Index Pencil::fewest_inside() const {
  Index inside = between_count_ + right_count_, fewest = inside;
  for (const Passed& passed : passed_) {
    inside += passed.on_left ? 1 : -1;
    fewest = std::min(fewest, inside);
  }
  return fewest;
}

void Pencil::put_in_order(Index i, std::size_t sample) {
  const Point &u = around_.graph().point(around_.centre()), &v = around_.point(i);
  passed_.clear();
  right_count_ = between_count_ = 0;
  Index left_count = 0;
  for (Index p = 0; p < around_.size(); ++p) {
    if (left_count >= sample && right_count_ >= sample) break;
    if (p == i) continue;
    const int s = side_of(i, p);
    if (s == 0) {  // always inside, or never
      between_count_ += is_between(i, p);
      continue;
    }
    if ((s > 0 ? left_count : right_count_) >= sample) continue;
    ++(s > 0 ? left_count : right_count_);
    passed_.push_back({Passing::of(u, v, around_.point(p)), p, s > 0});
  }
  std::sort(passed_.begin(), passed_.end(),
            [&](const Passed& p, const Passed& q) { return is_passed_before(i, p, q); });
}

bool Pencil::is_passed_before(Index i, const Passed& p, const Passed& q) const {
  if (p.at.is_surely_before(q.at)) return true;
  if (q.at.is_surely_before(p.at)) return false;
  if (p.vertex == q.vertex) return false;
  // Where q is passed, p on the left is inside already, or p on the right is outside.
  return is_inside(i, q.vertex, q.on_left ? Side::left : Side::right, p.vertex) == p.on_left;
}

}  // namespace hodt
