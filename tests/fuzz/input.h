// What the fuzz targets share: bytes as an input in memory, and the promises of every reader.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <vector>

#include "hodt/base/buffer.h"
#include "hodt/geometry/point_set.h"
#include "hodt/io/input_text.h"
#include "hodt/tin/tin.h"

#if defined(__SANITIZE_ADDRESS__)
#define HODT_FUZZ_POISONS
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define HODT_FUZZ_POISONS
#endif
#endif
#ifdef HODT_FUZZ_POISONS
#include <sanitizer/asan_interface.h>
#endif

namespace hodt::fuzz {

/// Bytes as read_input() hands them out. The memory right after the padding must not be touched,
/// and the address sanitizer sees if it is.
class Input {
 public:
  explicit Input(std::string_view bytes) {
    constexpr std::size_t block = 64;
    const std::size_t used = bytes.size() + InputText::kPadding;
    text_.bytes = Buffer<char>((used + block) / block * block);
    text_.size = bytes.size();
    text_.name = "input";
    char* const data = text_.bytes.data();
    if (!bytes.empty()) std::memcpy(data, bytes.data(), bytes.size());
    data[bytes.size()] = '\n';
    std::memset(data + bytes.size() + 1, 0, InputText::kPadding - 1);
#ifdef HODT_FUZZ_POISONS
    __asan_poison_memory_region(data + used, text_.bytes.size() - used);
#endif
  }
  ~Input() {
#ifdef HODT_FUZZ_POISONS
    __asan_unpoison_memory_region(text_.bytes.data(), text_.bytes.size());
#endif
  }
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;

  const InputText& text() const {
    return text_;
  }

 private:
  InputText text_;
};

/// Ends the process where a promise is broken: what a fuzzer takes for a find.
inline void require(bool promise) {
  if (!promise) std::abort();
}

inline void require_sound(const std::vector<Point>& points) {
  for (const Point& p : points) require(std::isfinite(p.x) && std::isfinite(p.y));
}

inline void require_sound(const PointSet& points) {
  require(points.z.empty() || points.z.size() == points.xy.size());
  require_sound(points.xy);
  for (const double z : points.z) require(std::isfinite(z));
}

inline void require_sound(const Tin& tin) {
  require_sound(tin.points);
  require(!tin.triangles.empty());
  for (const auto& triangle : tin.triangles)
    for (const Index corner : triangle) require(corner < tin.points.size());
}

}  // namespace hodt::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
