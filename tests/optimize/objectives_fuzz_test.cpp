// What tests/fuzz/objectives.cpp checks, for some random bytes: a defect aborts the test.
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "../fuzz/objectives.cpp"  // NOLINT: it is a program without a main
#include <gtest/gtest.h>

namespace {

std::vector<std::uint8_t> random_bytes(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::uint8_t> bytes(64);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
  return bytes;
}

/// HODT_FUZZ_SECONDS: so long, from HODT_FUZZ_SEED on, in place of a few hundred sets.
TEST(ObjectivesFuzz, random_bytes) {
  const char* const seconds = std::getenv("HODT_FUZZ_SECONDS");
  const char* const first = std::getenv("HODT_FUZZ_SEED");
  const auto start = std::chrono::steady_clock::now();
  const std::uint64_t begin = first != nullptr ? std::stoull(first) : 0;
  std::uint64_t seed = begin;
  const auto is_over = [&] {
    if (seconds == nullptr) return seed - begin >= 400;
    return std::chrono::steady_clock::now() - start > std::chrono::seconds(std::stoi(seconds));
  };
  for (; !is_over(); ++seed) {
    const std::vector<std::uint8_t> bytes = random_bytes(seed);
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
  std::printf("%llu sets\n", static_cast<unsigned long long>(seed - begin));
}

}  // namespace
