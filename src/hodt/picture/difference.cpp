#include "hodt/picture/difference.h"

#include <algorithm>
#include <iterator>

namespace hodt {
namespace {

std::vector<Edge> edges_of(const Tin& tin) {
  std::vector<Edge> edges;
  edges.reserve(3 * tin.triangles.size());
  for (const auto& corner : tin.triangles) {
    for (int i = 0; i < 3; ++i) {
      const Index a = corner[i];
      const Index b = corner[(i + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

bool lower(const PointSet& points, Index a, Index b) {
  if (points.z[a] != points.z[b]) return points.z[a] < points.z[b];
  return lexicographically_less(points.xy[a], points.xy[b]);
}

std::vector<Index> minima_of(const PointSet& points, const std::vector<Edge>& edges) {
  enum class State : char { in_no_edge, lowest, not_lowest };
  std::vector<State> state(points.size(), State::in_no_edge);
  for (const auto& [a, b] : edges) {
    const bool a_is_lower = lower(points, a, b);
    State& low = state[a_is_lower ? a : b];
    if (low == State::in_no_edge) low = State::lowest;
    state[a_is_lower ? b : a] = State::not_lowest;
  }
  std::vector<Index> minima;
  for (Index vertex = 0; vertex < state.size(); ++vertex) {
    if (state[vertex] == State::lowest) minima.push_back(vertex);
  }
  return minima;
}

/// The elements of sorted `a` that are not in sorted `b`.
template <class T>
std::vector<T> without(const std::vector<T>& a, const std::vector<T>& b) {
  std::vector<T> result;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

}  // namespace

Difference difference(const Tin& before, const Tin& after) {
  const std::vector<Edge> old_edges = edges_of(before);
  const std::vector<Edge> new_edges = edges_of(after);
  Difference result;
  result.removed = without(old_edges, new_edges);
  result.added = without(new_edges, old_edges);
  result.kept = without(old_edges, result.removed);
  result.remaining_minima = minima_of(after.points, new_edges);
  const std::vector<Index> old_minima = minima_of(before.points, old_edges);
  result.minima_before = old_minima.size();
  result.vanished_minima = without(old_minima, result.remaining_minima);
  return result;
}

}  // namespace hodt
