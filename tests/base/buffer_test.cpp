#include "hodt/base/buffer.h"

#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include <gtest/gtest.h>

namespace hodt {
namespace {

TEST(Buffer, copies_are_apart_and_moves_take_all) {
  Buffer<int> a(1000);
  std::iota(a.begin(), a.end(), 0);
  Buffer<int> b = a;
  b[7] = -1;
  EXPECT_EQ(a[7], 7);
  const int* memory = a.data();
  const Buffer<int> c = std::move(a);
  EXPECT_EQ(c.data(), memory);
  EXPECT_EQ(c.size(), 1000u);
  b = c;
  EXPECT_EQ(b[999], 999);
  EXPECT_EQ(std::span<const int>(b).size(), 1000u);
}

TEST(Buffer, of_every_size_is_aligned) {
  for (const std::size_t bytes : {1u, 63u, 64u, 65u, (1u << 21) - 1, 1u << 21, (1u << 21) + 1}) {
    Buffer<std::uint8_t> buffer(bytes, 3);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(buffer.data()) % 64, 0u) << bytes;
    EXPECT_EQ(buffer[bytes - 1], 3) << bytes;
  }
}

TEST(Buffer, of_nothing_is_empty) {
  const Buffer<double> none(0, 1.0);
  const Buffer<double> copy = none;
  EXPECT_TRUE(none.empty() && copy.empty());
  EXPECT_EQ(copy.begin(), copy.end());
}

TEST(Buffer, forgets_what_is_cut_off) {
  Buffer<int> buffer(5, 1);
  buffer.shrink(2);
  EXPECT_EQ(buffer.size(), 2u);
  EXPECT_EQ(std::accumulate(buffer.begin(), buffer.end(), 0), 2);
}

TEST(Buffer, too_large_throws) {
  EXPECT_THROW(Buffer<char>(std::size_t{1} << 62), std::bad_alloc);
}

}  // namespace
}  // namespace hodt
