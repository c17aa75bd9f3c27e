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
/// an earlier one. It is called by several threads at once, while `sink` is called by another one,
/// not always the same. Returns how many were appended.
template <class Feature, class Append, class Sink>
std::size_t make_feature_texts(std::size_t count, const Append& append, const Sink& sink) {
  // A batch of pieces bounds the memory; the cut depends on nothing but the count.
  constexpr std::size_t piece_size = 512, pieces_in_batch = 64;
  constexpr std::size_t batch_size = piece_size * pieces_in_batch;
  struct Piece {
    std::string text;
    std::size_t appended = 0;
  };
  using Batch = std::vector<Piece>;
  const auto make = [&](std::size_t first, Batch& batch) {
    const std::size_t end = std::min(first + batch_size, count);
    batch.resize((end - first + piece_size - 1) / piece_size);
    parallel_for(0, batch.size(), 1, [&](std::size_t begin, std::size_t last) {
      Feature feature;
      for (std::size_t p = begin; p < last; ++p) {
        batch[p].text.clear();
        batch[p].appended = 0;
        const std::size_t from = first + p * piece_size;
        for (std::size_t i = from; i < std::min(from + piece_size, end); ++i)
          batch[p].appended += append(i, feature, batch[p].text) ? 1 : 0;
      }
    });
  };
  std::size_t appended = 0;
  const auto write = [&](const Batch& batch) {
    for (const Piece& piece : batch) {
      if (piece.appended == 0) continue;
      sink(std::string_view(piece.text));
      appended += piece.appended;
    }
  };
  // One batch is written while the next one is made.
  Batch made, next;
  for (std::size_t first = 0; first < count; first += batch_size) {
    parallel_invoke([&] { write(made); }, [&] { make(first, next); });
    made.swap(next);
  }
  write(made);
  return appended;
}

}  // namespace hodt
