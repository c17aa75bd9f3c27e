// Many features turned into text by all cores, written in order.
// Tested by tests/io/feature_file_test.cpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "hodt/base/parallel.h"
#include "hodt/io/atomic_write.h"

namespace hodt {

/// Has the features 0 to count - 1 appended to texts, and hands these to `sink` in their order.
/// append(i, feature, text) returns whether it appended anything; `feature` is a Feature that holds
/// an earlier one. It is called by several threads at once. Returns how many were appended.
template <class Feature, class Append, class Sink>
std::size_t make_feature_texts(std::size_t count, const Append& append, const Sink& sink) {
  // A batch of pieces bounds the memory; the cut depends on nothing but the count.
  constexpr std::size_t piece_size = 512, pieces_in_batch = 64;
  struct Piece {
    std::string text;
    std::size_t appended = 0;
  };
  std::vector<Piece> batch(pieces_in_batch);
  std::size_t appended = 0;
  for (std::size_t first = 0; first < count; first += piece_size * pieces_in_batch) {
    const std::size_t pieces =
        std::min((count - first + piece_size - 1) / piece_size, pieces_in_batch);
    parallel_for(0, pieces, 1, [&](std::size_t begin, std::size_t end) {
      Feature feature;
      for (std::size_t p = begin; p < end; ++p) {
        batch[p].text.clear();
        batch[p].appended = 0;
        const std::size_t last = std::min(first + (p + 1) * piece_size, count);
        for (std::size_t i = first + p * piece_size; i < last; ++i)
          batch[p].appended += append(i, feature, batch[p].text) ? 1 : 0;
      }
    });
    for (std::size_t p = 0; p < pieces; ++p) {
      if (batch[p].appended == 0) continue;
      sink(std::string_view(batch[p].text));
      appended += batch[p].appended;
    }
  }
  return appended;
}

}  // namespace hodt
