// One loop compiled for several instruction sets; the processor at hand picks. Fused multiply-add
// stays out (see -ffp-contract), so that all of them round alike.
// Tested by tests/order/near_points_test.cpp.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define HODT_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define HODT_CLONES
#endif
