#include "hodt/optimize/solve/edge_selection.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "families.h"
#include <gtest/gtest.h>

namespace hodt {
namespace {

using Pairs = std::vector<std::pair<Index, Index>>;

struct Plain {
  Index targets, edges;
  Pairs serves;  // edge, target
  Pairs rivals;

  SelectionProblem problem() const {
    Pairs of_target, both;
    for (const auto& [e, t] : serves) of_target.emplace_back(t, e);
    for (const auto& [e, f] : rivals) {
      both.emplace_back(e, f);
      both.emplace_back(f, e);
    }
    return {CsrLists(targets, of_target), CsrLists(edges, serves), CsrLists(edges, both),
            std::vector<Index>(edges, 1)};
  }
  bool is_allowed(std::uint32_t chosen) const {
    return std::none_of(rivals.begin(), rivals.end(), [&](const auto& pair) {
      return (chosen >> pair.first & 1) && (chosen >> pair.second & 1);
    });
  }
  std::size_t unserved(std::uint32_t chosen) const {
    std::set<Index> served;
    for (const auto& [e, t] : serves)
      if (chosen >> e & 1) served.insert(t);
    return targets - served.size();
  }
  /// By every set of edges.
  std::size_t optimum() const {
    std::size_t best = targets;
    for (std::uint32_t chosen = 0; chosen < 1u << edges; ++chosen)
      if (is_allowed(chosen)) best = std::min(best, unserved(chosen));
    return best;
  }
};

Plain random_problem(families::Random& random, int targets, int edges, int rivals) {
  Plain plain{Index(targets), Index(edges), {}, {}};
  for (int t = 0; t < targets; ++t)  // one edge at least
    plain.serves.emplace_back(Index(random.integer(0, edges - 1)), Index(t));
  for (int e = 0; e < edges; ++e)
    plain.serves.emplace_back(Index(e), Index(random.integer(0, targets - 1)));
  for (int i = 0; i < rivals; ++i) {
    const int e = random.integer(0, edges - 1), f = random.integer(0, edges - 1);
    if (e != f) plain.rivals.emplace_back(Index(e), Index(f));
  }
  return plain;
}

std::uint32_t bits(const std::vector<Index>& edges) {
  std::uint32_t chosen = 0;
  for (const Index e : edges) chosen |= 1u << e;
  return chosen;
}

std::size_t bound(const Selection& selection) {
  std::size_t sum = 0;
  for (const Selection::Part& part : selection.contested) sum += part.unserved;
  return sum;
}

TEST(ChooseEdges, serves_as_many_as_can_be) {
  families::Random random(7);
  std::size_t contested = 0;
  for (int round = 0; round < 1500; ++round) {
    const int targets = random.integer(2, 9), edges = random.integer(2, 14);
    const Plain plain = random_problem(random, targets, edges, random.integer(0, 3 * edges));
    const Selection selection = select_edges(plain.problem(), Deadline(), 1'000'000);
    const std::uint32_t chosen = bits(selection.edges);
    ASSERT_TRUE(plain.is_allowed(chosen)) << round;
    ASSERT_EQ(plain.unserved(chosen), plain.optimum()) << round;
    ASSERT_EQ(bound(selection), plain.optimum()) << round;
    contested += bound(selection) > 0;
  }
  EXPECT_GT(contested, 500u);
}

/// Without a single program the selection is allowed all the same, and the bound valid.
TEST(ChooseEdges, ends_early_with_what_it_has) {
  families::Random random(8);
  for (int round = 0; round < 500; ++round) {
    const Plain plain = random_problem(random, 8, 12, 24);
    for (const std::size_t work : {0, 160, 400}) {
      const Selection selection = select_edges(plain.problem(), Deadline(), work);
      const std::uint32_t chosen = bits(selection.edges);
      ASSERT_TRUE(plain.is_allowed(chosen)) << round;
      ASSERT_GE(plain.unserved(chosen), plain.optimum()) << round;
      ASSERT_LE(bound(selection), plain.optimum()) << round;
    }
  }
}

/// Rivals around an odd ring, two to a target: the relaxation has every edge half in.
TEST(ChooseEdges, branches_where_the_relaxation_is_fractional) {
  for (const Index n : {5, 7, 9}) {
    Plain plain{n, n, {}, {}};
    for (Index i = 0; i < n; ++i) {
      plain.serves.emplace_back(i, i);
      plain.rivals.emplace_back(i, (i + 1) % n);
    }
    const Selection selection = select_edges(plain.problem(), Deadline(), 1'000'000);
    EXPECT_EQ(plain.unserved(bits(selection.edges)), n - n / 2);
    EXPECT_EQ(bound(selection), n - n / 2);
  }
}

}  // namespace
}  // namespace hodt
