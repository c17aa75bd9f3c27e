#include "hodt/picture/difference.h"

#include <algorithm>
#include <iterator>

namespace hodt {
namespace {

Edge edge_of(const std::array<Index, 3>& corner, int i) {
  const Index a = corner[i], b = corner[(i + 1) % 3];
  return {std::min(a, b), std::max(a, b)};
}

std::vector<Edge> edges_of(const Tin& tin) {
  std::vector<Edge> edges;
  edges.reserve(3 * tin.triangles.size());
  for (const auto& corner : tin.triangles)
    for (int i = 0; i < 3; ++i) edges.push_back(edge_of(corner, i));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

bool lower(const PointSet& points, Index a, Index b) {
  if (points.z[a] != points.z[b]) return points.z[a] < points.z[b];
  return lexicographically_less(points.xy[a], points.xy[b]);
}

struct Extrema {
  std::vector<Index> minima, maxima;
};

Extrema extrema_of(const PointSet& points, const std::vector<Edge>& edges) {
  constexpr char has_lower = 1, has_higher = 2;
  std::vector<char> state(points.size(), 0);
  for (const auto& [a, b] : edges) {
    const bool a_is_lower = lower(points, a, b);
    state[a_is_lower ? a : b] |= has_higher;
    state[a_is_lower ? b : a] |= has_lower;
  }
  Extrema extrema;
  for (Index vertex = 0; vertex < state.size(); ++vertex) {
    if (state[vertex] == has_higher) extrema.minima.push_back(vertex);
    if (state[vertex] == has_lower) extrema.maxima.push_back(vertex);
  }
  return extrema;
}

/// The elements of sorted `a` that are not in sorted `b`.
template <class T>
std::vector<T> without(const std::vector<T>& a, const std::vector<T>& b) {
  std::vector<T> result;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

ExtremaChange change(const std::vector<Index>& before, const std::vector<Index>& after) {
  ExtremaChange result;
  result.vanished = without(before, after);
  result.made = without(after, before);
  result.remaining = without(before, result.vanished);
  return result;
}

std::vector<Index> orders_of(const std::vector<Edge>& edges, const Tin& tin) {
  if (tin.order.empty()) return {};
  std::vector<Index> orders(edges.size(), 0);
  for (std::size_t t = 0; t < tin.triangles.size(); ++t) {
    if (!tin.is_changed(t)) continue;
    for (int i = 0; i < 3; ++i) {
      const Edge edge = edge_of(tin.triangles[t], i);
      const auto found = std::lower_bound(edges.begin(), edges.end(), edge);
      if (found == edges.end() || *found != edge) continue;
      Index& order = orders[static_cast<std::size_t>(found - edges.begin())];
      order = std::max(order, tin.order[t]);
    }
  }
  return orders;
}

}  // namespace

Difference difference(const Tin& before, const Tin& after, std::span<const Index> kept) {
  const std::vector<Edge> old_edges = edges_of(before);
  const std::vector<Edge> new_edges = edges_of(after);
  Difference result;
  result.removed = without(old_edges, new_edges);
  result.added = without(new_edges, old_edges);
  result.added_order = orders_of(result.added, after);
  result.kept = without(old_edges, result.removed);
  if (after.points.has_heights()) {
    const Extrema old_extrema = extrema_of(before.points, old_edges);
    const Extrema new_extrema = extrema_of(after.points, new_edges);
    result.minima = change(old_extrema.minima, new_extrema.minima);
    std::vector<Index>& remaining = result.minima.remaining;
    std::set_intersection(remaining.begin(), remaining.end(), kept.begin(), kept.end(),
                          std::back_inserter(result.minima.kept));
    remaining = without(remaining, result.minima.kept);
    result.maxima = change(old_extrema.maxima, new_extrema.maxima);
  }
  return result;
}

}  // namespace hodt
