#include "hodt/optimize/extrema/edge_owners.h"

#include <utility>
#include <vector>

#include "hodt/base/csr_lists.h"

namespace hodt {

namespace {

class Owners {
 public:
  Owners(std::size_t vertices, std::span<const PlainEdge> edges)
      : edges_(edges),
        partners_(vertices, kNone),
        unowned_(vertices, 0),
        is_owned_(edges.size(), false) {
    std::vector<std::pair<Index, Index>> ends;
    for (Index e = 0; e < edges.size(); ++e)
      for (const VertexId v : {edges[e].u, edges[e].v}) {
        ends.emplace_back(v, e);
        ++unowned_[v];
      }
    edges_at_ = CsrLists(vertices, ends);
  }

  /// Ends without another edge own theirs, and what is left goes around in rings.
  Buffer<Index> find() && {
    for (Index v = 0; v < unowned_.size(); ++v)
      if (unowned_[v] == 1) leaves_.push_back(v);
    take_leaves();
    for (Index e = 0; e < edges_.size(); ++e) {
      if (is_owned_[e]) continue;
      own_one(edges_[e].u);
      if (!is_owned_[e]) own_one(edges_[e].v);
      take_leaves();
    }
    return std::move(partners_);
  }

 private:
  void take_leaves() {
    while (!leaves_.empty()) {
      const Index v = leaves_.back();
      leaves_.pop_back();
      own_one(v);
    }
  }

  void own_one(Index v) {
    if (partners_[v] != kNone) return;
    for (const Index e : edges_at_[v]) {
      if (is_owned_[e]) continue;
      const VertexId other = edges_[e].u == v ? edges_[e].v : edges_[e].u;
      is_owned_[e] = true;
      partners_[v] = other;
      --unowned_[v];
      if (--unowned_[other] == 1) leaves_.push_back(other);
      return;
    }
  }

  const std::span<const PlainEdge> edges_;
  CsrLists edges_at_;
  Buffer<Index> partners_;
  Buffer<Index> unowned_;  // edges at each vertex
  Buffer<bool> is_owned_;
  std::vector<Index> leaves_;
};

}  // namespace

Buffer<Index> edge_owners(std::size_t vertices, std::span<const PlainEdge> edges) {
  return Owners(vertices, edges).find();
}

}  // namespace hodt
