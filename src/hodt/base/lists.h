// Lists of numbers, one after another in one array.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "hodt/base/ids.h"

namespace hodt {

class Lists {
 public:
  Lists() = default;
  /// `count` lists from pairs (list, item): each ascending, without repetitions.
  Lists(std::size_t count, std::vector<std::pair<Index, Index>> pairs) : first_(count + 1, 0) {
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    for (const auto& [list, item] : pairs) {
      ++first_[list + 1];
      items_.push_back(item);
    }
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
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
