// Decoding one chunk of a LAZ file.
// Tested by tests/io/las_test.cpp.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "hodt/io/las/laz_layout.h"
#include "hodt/io/las/raw_point.h"

namespace hodt::las {

/// A chunk's bytes, and how many points they hold. At least four more bytes are readable.
struct Chunk {
  const char* begin = nullptr;
  const char* end = nullptr;
  std::size_t points = 0;
};

/// Decodes chunk after chunk; a thread needs one of its own. Each chunk begins anew, so their order
/// does not matter.
class ChunkDecoder {
 public:
  ChunkDecoder() = default;
  ChunkDecoder(const ChunkDecoder&) = delete;
  ChunkDecoder& operator=(const ChunkDecoder&) = delete;
  virtual ~ChunkDecoder() = default;

  /// Adds the chunk's points. Throws Damage when it is clear that the bytes do not hold them; then
  /// the points added are those before.
  virtual void decode(const Chunk& chunk, std::vector<RawPoint>& points) = 0;
};

/// For points one after the other, formats 0 to 5.
std::unique_ptr<ChunkDecoder> make_pointwise_decoder(const LazLayout& layout);
/// For points in layers, formats 6 to 10.
std::unique_ptr<ChunkDecoder> make_layered_decoder(const LazLayout& layout);

}  // namespace hodt::las
