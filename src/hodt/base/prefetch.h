// Memory that is to be read soon.
// Tested by tests/order/near_points_test.cpp.
#pragma once

namespace hodt {

/// Asks for it, so that it is there by then. Where it is not at all, nothing happens.
inline void prefetch(const void* memory) {
#ifdef __GNUC__
  __builtin_prefetch(memory);
#else
  static_cast<void>(memory);
#endif
}

}  // namespace hodt
