#include "hodt/optimize/solve/diagonal_selection.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace hodt {

DiagonalSelection::DiagonalSelection(Buffer<Index> base, std::vector<Corners> quadrilaterals)
    : base_(std::move(base)),
      quadrilaterals_(std::move(quadrilaterals)),
      quadrilaterals_at_(base_.size()) {
  for (Index q = 0; q < quadrilaterals_.size(); ++q)
    for (const VertexId v : quadrilaterals_[q]) quadrilaterals_at_[v].push_back(q);
}

class DiagonalSelection::Search {
 public:
  Search(const DiagonalSelection& problem, Index most, const std::vector<bool>& preferred)
      : problem_(problem),
        most_(most),
        preferred_(preferred),
        degree_(problem.base_),
        state_(problem.quadrilaterals_.size(), kOpen) {}

  bool is_critical(VertexId v) const {
    return problem_.base_[v] + problem_.quadrilaterals_at_[v].size() > most_;
  }

  /// Decides all quadrilaterals of the part, or none.
  Answer decide(const std::vector<Index>& part, const Deadline& deadline) {
    constexpr std::size_t kMostSteps = 200'000;
    std::size_t steps = 0;
    for (const Index q : part)
      for (const VertexId v : problem_.quadrilaterals_[q]) to_check_.push_back(v);
    if (!propagate()) return undo_all(), Answer::impossible;
    struct Branch {
      std::size_t trail;  // its length before
      std::size_t next;   // all of the part before were decided
      Index quadrilateral;
      bool second;  // what was tried first
      bool is_last;
    };
    std::vector<Branch> branches;
    std::size_t next = 0;  // all of the part before are decided
    for (;;) {
      while (next < part.size() && state_[part[next]] != kOpen) ++next;
      if (next == part.size()) return trail_.clear(), Answer::possible;
      if (++steps > kMostSteps || deadline.passed()) return undo_all(), Answer::unknown;
      const Index q = part[next];
      branches.push_back({trail_.size(), next, q, preferred_[q], false});
      set(q, preferred_[q]);
      bool fits = propagate();
      while (!fits) {
        while (!branches.empty() && branches.back().is_last) branches.pop_back();
        if (branches.empty()) return undo_all(), Answer::impossible;
        Branch& branch = branches.back();
        undo_to(branch.trail);
        branch.is_last = true;
        next = branch.next;
        set(branch.quadrilateral, !branch.second);
        fits = propagate();
      }
    }
  }
  bool is_decided(Index q) const { return state_[q] != kOpen; }
  bool has_second(Index q) const { return state_[q] == kSecond; }

 private:
  enum State : std::uint8_t { kFirst, kSecond, kOpen };

  void set(Index q, bool second) {
    state_[q] = second ? kSecond : kFirst;
    trail_.push_back(q);
    const Corners& corners = problem_.quadrilaterals_[q];
    for (const VertexId v : {corners[second ? 2 : 0], corners[second ? 3 : 1]}) {
      ++degree_[v];
      to_check_.push_back(v);
    }
  }
  void undo_to(std::size_t length) {
    to_check_.clear();
    while (trail_.size() > length) {
      const Index q = trail_.back();
      trail_.pop_back();
      const Corners& corners = problem_.quadrilaterals_[q];
      const bool second = state_[q] == kSecond;
      for (const VertexId v : {corners[second ? 2 : 0], corners[second ? 3 : 1]}) --degree_[v];
      state_[q] = kOpen;
    }
  }
  void undo_all() { undo_to(0); }

  /// A vertex that is full takes no more diagonals.
  bool propagate() {
    while (!to_check_.empty()) {
      const VertexId v = to_check_.back();
      to_check_.pop_back();
      if (degree_[v] > most_) return false;
      if (degree_[v] < most_) continue;
      for (const Index q : problem_.quadrilaterals_at_[v]) {
        if (state_[q] != kOpen) continue;
        const Corners& corners = problem_.quadrilaterals_[q];
        set(q, corners[0] == v || corners[1] == v);
      }
    }
    return true;
  }

  const DiagonalSelection& problem_;
  const Index most_;
  const std::vector<bool>& preferred_;
  Buffer<Index> degree_;
  std::vector<State> state_;
  std::vector<Index> trail_;
  std::vector<VertexId> to_check_;
};

DiagonalSelection::Answer DiagonalSelection::keep_below(Index most, std::vector<bool>& chosen,
                                                        const Deadline& deadline) const {
  if (*std::max_element(base_.begin(), base_.end()) > most) return Answer::impossible;
  Search search(*this, most, chosen);
  std::vector<bool> seen(quadrilaterals_.size(), false);
  Answer answer = Answer::possible;
  for (VertexId v(0); v < base_.size(); v = VertexId(v + 1)) {
    if (!search.is_critical(v)) continue;
    // All that hangs together by critical vertices.
    std::vector<Index> part;
    const auto take_all_at = [&](VertexId w) {
      if (!search.is_critical(w)) return;
      for (const Index q : quadrilaterals_at_[w]) {
        if (seen[q]) continue;
        seen[q] = true;
        part.push_back(q);
      }
    };
    take_all_at(v);
    for (std::size_t next = 0; next < part.size(); ++next)
      for (const VertexId w : quadrilaterals_[part[next]]) take_all_at(w);
    if (part.empty()) continue;
    const Answer own = search.decide(part, deadline);
    if (own == Answer::impossible) return own;
    if (own == Answer::unknown) answer = own;
  }
  if (answer == Answer::possible)
    for (Index q = 0; q < quadrilaterals_.size(); ++q)
      if (search.is_decided(q)) chosen[q] = search.has_second(q);
  return answer;
}

}  // namespace hodt
