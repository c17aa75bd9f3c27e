// Many records formatted by all cores, written in order.
// Tested by tests/io/point_file_test.cpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string_view>

#include "hodt/base/buffer.h"
#include "hodt/base/parallel.h"
#include "hodt/io/atomic_write.h"

namespace hodt {

/// Writes the text at `to`; returns the end.
inline char* put_text(char* to, std::string_view text) {
  std::memcpy(to, text.data(), text.size());
  return to + text.size();
}

/// Formats records 0 to count - 1 and hands the bytes to `sink` in their order, a piece at a time.
/// format(i, to) writes record i at `to`, at most `longest` bytes, and returns its end.
template <class Format, class Sink>
void format_records(std::size_t count, std::size_t longest, const Format& format,
                    const Sink& sink) {
  // Each piece lands in a slot of its own, long enough for the worst case; a batch of slots bounds
  // the memory. The cut depends on nothing but the count.
  constexpr std::size_t piece = 4096, pieces_in_batch = 64;
  const std::size_t slot = piece * longest;
  Buffer<char> batch(std::min(count / piece + 1, pieces_in_batch) * slot);
  std::size_t used[pieces_in_batch];
  for (std::size_t first = 0; first < count; first += piece * pieces_in_batch) {
    const std::size_t pieces = std::min((count - first + piece - 1) / piece, pieces_in_batch);
    parallel_for(0, pieces, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p) {
        char* const start = batch.data() + p * slot;
        char* to = start;
        const std::size_t last = std::min(first + (p + 1) * piece, count);
        for (std::size_t i = first + p * piece; i < last; ++i) to = format(i, to);
        used[p] = static_cast<std::size_t>(to - start);
      }
    });
    for (std::size_t p = 0; p < pieces; ++p) {
      sink(std::string_view(batch.data() + p * slot, used[p]));
    }
  }
}

/// The same, into a file.
template <class Format>
void write_records(OutputFile& file, std::size_t count, std::size_t longest, const Format& format) {
  format_records(count, longest, format, [&](std::string_view bytes) { file.write(bytes); });
}

}  // namespace hodt
