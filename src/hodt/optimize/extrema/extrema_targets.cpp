#include "hodt/optimize/extrema/extrema_targets.h"

#include <algorithm>

namespace hodt {

namespace {

constexpr Index kFirstSearch = 4;  // the order up to which every target's edges are searched
constexpr std::size_t kMostOffered = 256;
constexpr std::size_t kEffort = 1 << 24;  // questions of a search; orders below 200 take far fewer

}  // namespace

ExtremaTargets::ExtremaTargets(const DelaunayGraph& graph, const Heights& heights,
                               const Buffer<bool>& kept, Index order, const Deadline& deadline)
    : graph_(graph),
      heights_(heights),
      kept_(kept),
      order_(order),
      deadline_(deadline),
      known_(graph.xy.size(), 0),
      searches_([&graph] { return UsefulEdgeSearch(graph); }) {
  for (Index i = 1; i < known_.size(); ++i) {
    if (heights_.lower(VertexId(i), lowest_)) lowest_ = VertexId(i);
    if (heights_.lower(highest_, VertexId(i))) highest_ = VertexId(i);
  }
}

/// The lowest vertex of all has no edge that helps it, and need not be searched, nor minima that
/// are to stay.
bool ExtremaTargets::add(VertexId v, Extremum kind) {
  if (known_[v] & bit(kind)) return false;
  known_[v] |= bit(kind);
  const bool stays = kind == Extremum::minimum ? v == lowest_ || kept_[v] : v == highest_;
  targets_.push_back({.vertex = v, .kind = kind, .edges = {}, .searched = stays ? order_ : 0});
  return true;
}

std::size_t ExtremaTargets::hopeless() const {
  return std::size_t(std::count_if(targets_.begin(), targets_.end(), [&](const Target& target) {
    return target.edges.empty() && is_searched(target);
  }));
}

void ExtremaTargets::find_edges() {
  for (std::uint64_t order = kFirstSearch;; order = 4 * order) {
    const Index level = Index(std::min<std::uint64_t>(order, order_));
    parallel_for(0, targets_.size(), 64, [&](std::size_t first, std::size_t last) {
      UsefulEdgeSearch& search = searches_.mine();
      for (std::size_t i = first; i < last; ++i)
        if (targets_[i].edges.empty() && needs_search(targets_[i]) && !deadline_.passed())
          search_up_to(search, targets_[i], level);
    });
    if (level == order_) break;
  }
}

bool ExtremaTargets::offer_more_edges(const std::vector<Index>& targets) {
  std::vector<Index> open;
  bool has_more = false;
  for (const Index t : targets) {
    Target& target = targets_[t];
    if (target.offered < std::min(target.edges.size(), kMostOffered)) {
      target.offered *= 4;
      has_more = true;
    } else if (needs_search(target)) {
      open.push_back(t);
    }
  }
  parallel_for(0, open.size(), 8, [&](std::size_t first, std::size_t last) {
    UsefulEdgeSearch& search = searches_.mine();
    for (std::size_t i = first; i < last; ++i)
      if (!deadline_.passed()) search_up_to(search, targets_[open[i]], order_);
  });
  return has_more || !open.empty();
}

/// If time is up, the target's edges stay unknown.
void ExtremaTargets::search_up_to(UsefulEdgeSearch& search, Target& target, Index order) const {
  try {
    search_all_up_to(search, target, order);
  } catch (const TimeIsUp&) {
    target.given_up = true;
  }
}

void ExtremaTargets::search_all_up_to(UsefulEdgeSearch& search, Target& target, Index order) const {
  // An edge to a minimum that is to stay would remove it.
  const auto wanted = [&](VertexId v) {
    return heights_.removes(v, target.vertex, target.kind) &&
           !(target.kind == Extremum::maximum && kept_[v]);
  };
  search.limit_effort(kEffort);
  search.end_at(deadline_);
  const auto& found = search.from(target.vertex, order, wanted);
  if (!search.complete()) {
    target.given_up = true;
    return;
  }
  target.searched = order;
  target.edges.clear();
  // Delaunay edges are of no help to an extremum of the Delaunay triangulation, only to one that
  // another edge brought about.
  graph_.for_each_neighbour(target.vertex, [&](VertexId v) {
    if (wanted(v)) target.edges.push_back({v, 0});
  });
  target.edges.insert(target.edges.end(), found.begin(), found.end());
}

}  // namespace hodt
