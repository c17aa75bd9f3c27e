#include "hodt/optimize/solve/choose_edges.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <span>
#include <utility>

#include "hodt/base/buffer.h"
#include "hodt/base/parallel.h"
#include "hodt/optimize/solve/binary_program.h"

namespace hodt {

namespace {

/// How many rivals are looked at to compare edges, before a kernel stays larger than it had to.
constexpr std::size_t kMostComparing = 100'000'000;

/// The problem while it shrinks to what is hard about it.
class Kernel {
 public:
  explicit Kernel(const ChoiceProblem& problem);

  void finish_greedily();
  const std::vector<Index>& taken() const { return taken_; }

  bool has_target(Index t) const { return has_target_[t]; }
  /// What is left of a list.
  std::vector<Index> edges_of(Index target) const { return left(problem_.edges_of[target]); }
  std::vector<Index> rivals(Index edge) const { return left(problem_.rivals[edge]); }
  std::vector<Index> targets_of(Index edge) const {
    std::vector<Index> targets;
    for (const Index t : problem_.targets_of[edge])
      if (has_target_[t]) targets.push_back(t);
    return targets;
  }

 private:
  void shrink();
  std::vector<Index> left(std::span<const Index> edges) const {
    std::vector<Index> found;
    for (const Index e : edges)
      if (has_edge_[e]) found.push_back(e);
    return found;
  }
  void look_again(Index target) {
    if (!has_target_[target] || is_queued_[target]) return;
    is_queued_[target] = true;
    queue_.push_back(target);
  }
  bool take_free_edge(const std::vector<Index>& edges);
  void drop_worse_edges(const std::vector<Index>& edges);
  bool is_as_good(Index e, Index f);
  void take(Index edge);
  void drop(Index edge);

  const ChoiceProblem& problem_;
  Buffer<bool> has_edge_, has_target_, is_queued_;
  Buffer<Index> rivals_left_;   // of each edge
  Buffer<Index> targets_left_;  // of each edge
  std::vector<Index> queue_, taken_;
  std::size_t comparing_left_ = kMostComparing;
};

Kernel::Kernel(const ChoiceProblem& problem)
    : problem_(problem),
      has_edge_(problem.rivals.size(), true),
      has_target_(problem.edges_of.size(), true),
      is_queued_(problem.edges_of.size(), false),
      rivals_left_(problem.rivals.size()),
      targets_left_(problem.rivals.size()) {
  for (Index e = 0; e < rivals_left_.size(); ++e) {
    rivals_left_[e] = Index(problem.rivals[e].size());
    targets_left_[e] = Index(problem.targets_of[e].size());
  }
  for (Index t = 0; t < has_target_.size(); ++t) look_again(t);
  shrink();
}

void Kernel::shrink() {
  for (std::size_t i = 0; i < queue_.size(); ++i) {
    const Index t = queue_[i];
    is_queued_[t] = false;
    if (!has_target_[t]) continue;
    const std::vector<Index> edges = edges_of(t);
    if (edges.empty())
      has_target_[t] = false;
    else if (!take_free_edge(edges))
      drop_worse_edges(edges);
  }
  queue_.clear();
}

/// Each target in turn gets the edge that excludes the fewest others.
void Kernel::finish_greedily() {
  for (Index t = 0; t < has_target_.size(); ++t) {
    if (!has_target_[t]) continue;
    const std::vector<Index> edges = edges_of(t);
    const Index best = *std::min_element(edges.begin(), edges.end(), [&](Index e, Index f) {
      return rivals_left_[e] < rivals_left_[f];
    });
    for (const Index rival : rivals(best)) drop(rival);
    look_again(t);
    shrink();
  }
}

bool Kernel::take_free_edge(const std::vector<Index>& edges) {
  Index best = kNone;
  for (const Index e : edges)
    if (rivals_left_[e] == 0 && (best == kNone || problem_.orders[e] < problem_.orders[best]))
      best = e;
  if (best != kNone) take(best);
  return best != kNone;
}

void Kernel::take(Index edge) {
  taken_.push_back(edge);
  for (const Index t : targets_of(edge)) {
    has_target_[t] = false;
    for (const Index e : edges_of(t)) {
      if (--targets_left_[e] == 0) {
        drop(e);
      } else {
        for (const Index other : targets_of(e)) look_again(other);
      }
    }
  }
}

void Kernel::drop(Index edge) {
  has_edge_[edge] = false;
  for (const Index rival : rivals(edge)) {
    --rivals_left_[rival];
    for (const Index t : targets_of(rival)) look_again(t);
  }
  for (const Index t : targets_of(edge)) look_again(t);
}

void Kernel::drop_worse_edges(const std::vector<Index>& edges) {
  for (const Index e : edges)
    for (const Index f : edges)
      if (e != f && has_edge_[e] && has_edge_[f] && is_as_good(e, f)) drop(f);
}

/// Whether whoever has f could as well have e.
bool Kernel::is_as_good(Index e, Index f) {
  if (rivals_left_[e] > rivals_left_[f] || targets_left_[e] < targets_left_[f]) return false;
  const std::size_t cost = problem_.rivals[e].size() + problem_.rivals[f].size();
  if (comparing_left_ < cost) return false;
  comparing_left_ -= cost;
  const auto includes = [](const std::vector<Index>& all, const std::vector<Index>& some) {
    return std::includes(all.begin(), all.end(), some.begin(), some.end());
  };
  return includes(targets_of(e), targets_of(f)) && includes(rivals(f), rivals(e));
}

/// Some of the targets and edges, with numbers of their own.
struct Part {
  ChoiceProblem problem;
  std::vector<Index> targets, edges;  // their numbers in the whole
};

template <class EdgesOf, class Rivals>
Part part_of(const ChoiceProblem& whole, std::vector<Index> targets, const EdgesOf& edges_of,
             const Rivals& rivals) {
  Part part{{}, std::move(targets), {}};
  for (const Index t : part.targets)
    for (const Index e : edges_of(t)) part.edges.push_back(e);
  std::sort(part.edges.begin(), part.edges.end());
  part.edges.erase(std::unique(part.edges.begin(), part.edges.end()), part.edges.end());
  const auto number = [&](Index e) {
    return Index(std::lower_bound(part.edges.begin(), part.edges.end(), e) - part.edges.begin());
  };
  std::vector<std::pair<Index, Index>> edges, served, excluded;
  for (Index t = 0; t < part.targets.size(); ++t)
    for (const Index e : edges_of(part.targets[t])) {
      edges.emplace_back(t, number(e));
      served.emplace_back(number(e), t);
    }
  for (Index e = 0; e < part.edges.size(); ++e) {
    part.problem.orders.push_back(whole.orders[part.edges[e]]);
    for (const Index r : rivals(part.edges[e])) excluded.emplace_back(e, number(r));
  }
  part.problem.edges_of = Lists(part.targets.size(), edges);
  part.problem.targets_of = Lists(part.edges.size(), served);
  part.problem.rivals = Lists(part.edges.size(), excluded);
  return part;
}

/// What the kernel leaves falls apart into targets that share edges, or have edges that are rivals.
std::vector<Part> parts_of(const ChoiceProblem& problem, const Kernel& kernel) {
  std::vector<Part> parts;
  Buffer<bool> is_seen(problem.edges_of.size(), false);
  for (Index seed = 0; seed < is_seen.size(); ++seed) {
    if (!kernel.has_target(seed) || is_seen[seed]) continue;
    std::vector<Index> targets{seed};
    is_seen[seed] = true;
    const auto see = [&](Index edge) {
      for (const Index t : kernel.targets_of(edge)) {
        if (is_seen[t]) continue;
        is_seen[t] = true;
        targets.push_back(t);
      }
    };
    for (std::size_t i = 0; i < targets.size(); ++i)
      for (const Index e : kernel.edges_of(targets[i])) {
        see(e);
        for (const Index rival : kernel.rivals(e)) see(rival);
      }
    std::sort(targets.begin(), targets.end());
    parts.push_back(part_of(
        problem, std::move(targets), [&](Index t) { return kernel.edges_of(t); },
        [&](Index e) { return kernel.rivals(e); }));
  }
  return parts;
}

/// Edges that all exclude each other, so that every pair of rivals is in one such clique.
std::vector<std::vector<Index>> cliques(const ChoiceProblem& problem) {
  const auto are_rivals = [&](Index a, Index b) {
    return std::binary_search(problem.rivals[a].begin(), problem.rivals[a].end(), b);
  };
  std::vector<std::vector<Index>> cliques, covered(problem.rivals.size());
  for (Index e = 0; e < covered.size(); ++e)
    for (const Index f : problem.rivals[e]) {
      if (f < e || std::find(covered[e].begin(), covered[e].end(), f) != covered[e].end()) continue;
      std::vector<Index> clique{e, f};
      for (const Index g : problem.rivals[e])
        if (g != f && std::all_of(clique.begin() + 1, clique.end(),
                                  [&](Index other) { return are_rivals(g, other); }))
          clique.push_back(g);
      for (const Index a : clique)
        for (const Index b : clique)
          if (a < b) covered[a].push_back(b);
      cliques.push_back(std::move(clique));
    }
  return cliques;
}

/// The problem as a program: the variables are the edges, and then the targets, which are one if
/// they go without. One edge of a clique at most makes for a better relaxation than pairs do.
BinaryRows rows_of(const ChoiceProblem& problem) {
  const auto edges = Index(problem.rivals.size()), targets = Index(problem.edges_of.size());
  std::vector<std::pair<Index, Index>> entries;  // column and row
  BinaryRows rows;
  for (Index t = 0; t < targets; ++t) {
    for (const Index e : problem.edges_of[t]) entries.emplace_back(e, t);
    entries.emplace_back(edges + t, t);
    rows.low.push_back(1);
    rows.high.push_back(BinaryProgram::kInfinite);
  }
  for (const std::vector<Index>& clique : cliques(problem)) {
    for (const Index e : clique) entries.emplace_back(e, Index(rows.low.size()));
    rows.low.push_back(-BinaryProgram::kInfinite);
    rows.high.push_back(1);
  }
  const Lists by_column(edges + targets, entries);
  for (Index column = 0; column < by_column.size(); ++column) {
    for (const Index row : by_column[column]) rows.row.push_back(int(row));
    rows.first.push_back(rows.row.size());
  }
  rows.factor.assign(rows.row.size(), 1);
  return rows;
}

/// Branches, and shrinks what is left after every branching.
class Search {
 public:
  Search(const Deadline& deadline, std::size_t most_work)
      : deadline_(deadline), work_left_(most_work) {}

  struct Result {
    std::vector<Index> edges;
    std::size_t unserved = 0;  // by these edges
    std::size_t bound = 0;     // by any
  };
  /// The best choice for a problem that neither shrinks nor falls apart.
  Result solve_part(const ChoiceProblem& problem);

 private:
  Result solve(const ChoiceProblem& problem);
  Result solve_with(const ChoiceProblem& problem, Index edge);
  Result solve_without(const ChoiceProblem& problem, Index edge);
  Result solve_rest(const ChoiceProblem& problem, const std::vector<Index>& targets,
                    const Buffer<bool>& is_gone);

  const Deadline& deadline_;
  std::size_t work_left_;
};

Search::Result greedily(const ChoiceProblem& problem) {
  Kernel kernel(problem);
  kernel.finish_greedily();
  std::vector<Index> served;
  for (const Index e : kernel.taken())
    served.insert(served.end(), problem.targets_of[e].begin(), problem.targets_of[e].end());
  std::sort(served.begin(), served.end());
  served.erase(std::unique(served.begin(), served.end()), served.end());
  return {kernel.taken(), problem.edges_of.size() - served.size(), 0};
}

Search::Result Search::solve(const ChoiceProblem& problem) {
  const Kernel kernel(problem);
  Result all{kernel.taken(), 0, 0};
  for (const Part& part : parts_of(problem, kernel)) {
    const Result result = solve_part(part.problem);
    for (const Index e : result.edges) all.edges.push_back(part.edges[e]);
    all.unserved += result.unserved;
    all.bound += result.bound;
  }
  return all;
}

Search::Result Search::solve_part(const ChoiceProblem& problem) {
  Result best = greedily(problem);
  const std::size_t edges = problem.rivals.size(), variables = edges + problem.edges_of.size();
  std::size_t work = variables;
  for (Index e = 0; e < edges; ++e) work += problem.rivals[e].size() / 2;
  if (work > work_left_ / 4 || deadline_.passed()) return best;
  work_left_ -= work;
  std::vector<double> costs(variables, 0);
  std::fill(costs.begin() + std::ptrdiff_t(edges), costs.end(), 1.0);
  BinaryProgram program(rows_of(problem), variables, deadline_, 1);
  const BinaryProgram::Solution relaxed = program.minimize(costs, 0);
  best.bound = std::size_t(std::max(std::ceil(relaxed.bound), 0.0));
  if (best.unserved == best.bound) return best;

  // The edge that is mostly in; where it is, and where it is not.
  const auto in =
      std::max_element(relaxed.values.begin(), relaxed.values.begin() + std::ptrdiff_t(edges));
  const auto edge = Index(in - relaxed.values.begin());
  const Result with = solve_with(problem, edge);
  if (with.unserved < best.unserved) best = {with.edges, with.unserved, best.bound};
  if (best.unserved == best.bound) return best;
  const Result without = solve_without(problem, edge);
  if (without.unserved < best.unserved) best = {without.edges, without.unserved, best.bound};
  best.bound = std::max(best.bound, std::min(with.bound, without.bound));
  return best;
}

Search::Result Search::solve_with(const ChoiceProblem& problem, Index edge) {
  Buffer<bool> is_gone(problem.rivals.size(), false);
  is_gone[edge] = true;
  for (const Index rival : problem.rivals[edge]) is_gone[rival] = true;
  std::vector<Index> targets;
  for (Index t = 0; t < problem.edges_of.size(); ++t)
    if (!std::binary_search(problem.targets_of[edge].begin(), problem.targets_of[edge].end(), t))
      targets.push_back(t);
  Result result = solve_rest(problem, targets, is_gone);
  result.edges.push_back(edge);
  return result;
}

Search::Result Search::solve_without(const ChoiceProblem& problem, Index edge) {
  Buffer<bool> is_gone(problem.rivals.size(), false);
  is_gone[edge] = true;
  std::vector<Index> targets(problem.edges_of.size());
  std::iota(targets.begin(), targets.end(), Index{0});
  return solve_rest(problem, targets, is_gone);
}

Search::Result Search::solve_rest(const ChoiceProblem& problem, const std::vector<Index>& targets,
                                  const Buffer<bool>& is_gone) {
  const auto left = [&](std::span<const Index> edges) {
    std::vector<Index> found;
    for (const Index e : edges)
      if (!is_gone[e]) found.push_back(e);
    return found;
  };
  const auto edges_of = [&](Index t) { return left(problem.edges_of[t]); };
  std::vector<Index> served;
  for (const Index t : targets)
    if (!edges_of(t).empty()) served.push_back(t);
  const std::size_t lost = targets.size() - served.size();
  // Edges that serve none of them take no part.
  Buffer<bool> serves(problem.rivals.size(), false);
  for (const Index t : served)
    for (const Index e : edges_of(t)) serves[e] = true;
  const Part part = part_of(problem, std::move(served), edges_of, [&](Index e) {
    std::vector<Index> found;
    for (const Index r : left(problem.rivals[e]))
      if (serves[r]) found.push_back(r);
    return found;
  });
  Result result = solve(part.problem);
  for (Index& e : result.edges) e = part.edges[e];
  result.unserved += lost;
  result.bound += lost;
  return result;
}

}  // namespace

Choice choose_edges(const ChoiceProblem& problem, const Deadline& deadline, std::size_t most_work) {
  const Kernel kernel(problem);
  std::vector<Part> parts = parts_of(problem, kernel);
  std::vector<Search::Result> results(parts.size());
  parallel_for(0, parts.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      results[i] = Search(deadline, most_work).solve_part(parts[i].problem);
  });

  Choice choice{kernel.taken(), {}};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (const Index e : results[i].edges) choice.edges.push_back(parts[i].edges[e]);
    if (results[i].unserved > 0)
      choice.contested.push_back({std::move(parts[i].targets), results[i].bound});
  }
  std::sort(choice.edges.begin(), choice.edges.end());
  return choice;
}

}  // namespace hodt
