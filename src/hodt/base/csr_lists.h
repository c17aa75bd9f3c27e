// Lists of numbers, one after another in one array.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "hodt/base/deadline.h"
#include "hodt/base/ids.h"

namespace hodt {

class CsrLists {
 public:
  CsrLists() = default;
  /// `count` lists from pairs (list, item): each ascending, without repetitions. Throws TimeIsUp if
  /// the deadline passes.
  CsrLists(std::size_t count, const std::vector<std::pair<Index, Index>>& pairs,
           const Deadline& deadline = {})
      : first_(count + 1, 0), items_(pairs.size()) {
    for (const auto& [list, item] : pairs) ++first_[list + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (const auto& [list, item] : pairs) items_[next[list]++] = item;
    // Each list in order, and moved up to where the one before ends.
    std::size_t end = 0;
    for (std::size_t i = 0; i < count; ++i) {
      deadline.check();
      const auto begin = items_.begin() + std::ptrdiff_t(first_[i]);
      const auto last = items_.begin() + std::ptrdiff_t(first_[i + 1]);
      std::sort(begin, last);
      const auto unique_end = std::unique(begin, last);
      first_[i] = end;
      end = std::size_t(std::move(begin, unique_end, items_.begin() + std::ptrdiff_t(end)) -
                        items_.begin());
    }
    first_[count] = end;
    items_.resize(end);
  }

  std::size_t size() const { return first_.size() - 1; }
  std::span<const Index> operator[](Index list) const {
    return {items_.data() + first_[list], items_.data() + first_[list + 1]};
  }

 private:
  std::vector<std::size_t> first_ = {0};
  std::vector<Index> items_;
};

}  // namespace hodt
