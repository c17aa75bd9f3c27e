// Single precision values side by side, as many as the processor takes at once: for loops that the
// compiler does not turn into that by itself (see clones.h for those that it does).
//
// A kernel is a function template over the number of lanes, written with plain operators and
// HODT_INLINE. HODT_FOR_LANES(kernel) makes kernel_in_lanes(...) of it, which runs what fits.
// Tested by tests/order/near_points_test.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "hodt/base/ids.h"

#if defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>
#endif

#define HODT_INLINE_LAMBDA __attribute__((always_inline))
#define HODT_INLINE inline HODT_INLINE_LAMBDA

namespace hodt {

template <Index N>
struct Lanes {
  using Floats [[gnu::vector_size(N * sizeof(float))]] = float;
  /// What a comparison gives: -1 where it holds, 0 elsewhere.
  using Bits [[gnu::vector_size(N * sizeof(float))]] = std::int32_t;
};

// Vectors go by reference: how they are handed over by value depends on the instruction set.

template <class Vector, class Value>
HODT_INLINE void load(Vector& lanes, const Value* from) {
  std::memcpy(&lanes, from, sizeof(lanes));
}

template <class Vector, class Value>
HODT_INLINE void store(Value* to, const Vector& lanes) {
  std::memcpy(to, &lanes, sizeof(lanes));
}

/// Folds N values into one. operation(a, b, result) takes vectors, too, and must not care about the
/// order.
template <Index N, class Value, class Operation>
HODT_INLINE Value fold(const Value* values, const Operation& operation) {
  if constexpr (N == 1) {
    return *values;
  } else {
    using Half [[gnu::vector_size(N / 2 * sizeof(Value))]] = Value;
    Half low, high, both;
    load(low, values);
    load(high, values + N / 2);
    operation(low, high, both);
    Value rest[N / 2];
    store(&rest[0], both);
    return fold<N / 2>(&rest[0], operation);
  }
}

// Which lanes are below a limit, a bit each.
#if defined(__x86_64__) && defined(__GNUC__)
// Not forced inline, which may not cross the border between instruction sets; they are inlined all
// the same.
__attribute__((target("avx512f,bmi,bmi2"))) inline std::uint64_t below(
    const Lanes<16>::Floats& lanes, float limit) {
  return _mm512_cmp_ps_mask(lanes, _mm512_set1_ps(limit), _CMP_LT_OQ);
}
__attribute__((target("avx2,bmi,bmi2"))) inline std::uint64_t below(const Lanes<8>::Floats& lanes,
                                                                    float limit) {
  const __m256 is_below = _mm256_cmp_ps(lanes, _mm256_set1_ps(limit), _CMP_LT_OQ);
  return static_cast<std::uint32_t>(_mm256_movemask_ps(is_below));
}
inline std::uint64_t below(const Lanes<4>::Floats& lanes, float limit) {
  return static_cast<std::uint32_t>(_mm_movemask_ps(_mm_cmplt_ps(lanes, _mm_set1_ps(limit))));
}
#else
inline std::uint64_t below(const Lanes<4>::Floats& lanes, float limit) {
  std::uint64_t bits = 0;
  for (Index i = 0; i < 4; ++i) bits |= std::uint64_t{lanes[i] < limit} << i;
  return bits;
}
#endif

#if defined(__x86_64__) && defined(__GNUC__)
#define HODT_FOR_LANES(kernel)                                                              \
  template <class... Arguments>                                                             \
  __attribute__((target("avx512f,bmi,bmi2"))) auto kernel##_in_16(Arguments... arguments) { \
    return kernel<16>(arguments...);                                                        \
  }                                                                                         \
  template <class... Arguments>                                                             \
  __attribute__((target("avx2,bmi,bmi2"))) auto kernel##_in_8(Arguments... arguments) {     \
    return kernel<8>(arguments...);                                                         \
  }                                                                                         \
  template <class... Arguments>                                                             \
  auto kernel##_in_lanes(Arguments... arguments) {                                          \
    return lanes_in_use == 16  ? kernel##_in_16(arguments...)                               \
           : lanes_in_use == 8 ? kernel##_in_8(arguments...)                                \
                               : kernel<4>(arguments...);                                   \
  }

/// As many as the processor has: 16, 8 or 4.
inline Index native_lanes() {
  // All of them that have AVX2 have the instructions for bits as well, if nobody hides these.
  if (!__builtin_cpu_supports("bmi") || !__builtin_cpu_supports("bmi2")) return 4;
  if (__builtin_cpu_supports("avx512f")) return 16;
  return __builtin_cpu_supports("avx2") ? 8 : 4;
}
#else
#define HODT_FOR_LANES(kernel)                     \
  template <class... Arguments>                    \
  auto kernel##_in_lanes(Arguments... arguments) { \
    return kernel<4>(arguments...);                \
  }

inline Index native_lanes() {
  return 4;
}
#endif

/// The kernel may be a lambda: f.template operator()<N>(), itself HODT_INLINE.
template <Index N, class F>
HODT_INLINE auto run(const F& f) {
  return f.template operator()<N>();
}

inline Index lanes_in_use = native_lanes();

HODT_FOR_LANES(run)

/// As on a processor with fewer lanes (4 or 8), while it lives. For tests; nothing else may run.
class LaneLimit {
 public:
  explicit LaneLimit(Index most) { lanes_in_use = std::min(most, native_lanes()); }
  ~LaneLimit() { lanes_in_use = native_lanes(); }
  LaneLimit(const LaneLimit&) = delete;
  LaneLimit& operator=(const LaneLimit&) = delete;
};

}  // namespace hodt
