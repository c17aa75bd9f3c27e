#include "hodt/terrain/jacksboro.h"

#include <array>

#include "jacksboro_csv.inc"

#include "hodt/terrain/random.h"

namespace hodt {
namespace {

/// Takes a number off the front of `text`, with the separator behind it; a decimal point is passed
/// over, so that a number with one decimal comes out as tenths.
std::int64_t take_digits(std::string_view& text) {
  std::int64_t value = 0;
  std::size_t length = 0;
  for (; text[length] != ',' && text[length] != '\n'; ++length) {
    if (text[length] != '.') value = 10 * value + (text[length] - '0');
  }
  text.remove_prefix(length + 1);
  return value;
}

}  // namespace

std::string_view jacksboro_csv() {
  return kJacksboroCsv;
}

PointSet sample_jacksboro(std::size_t n, std::uint64_t seed) {
  std::string_view rows = jacksboro_csv();
  rows.remove_prefix(rows.find('\n') + 1);
  PointSet points;
  points.xy.reserve(n);
  points.z.reserve(n);
  for (std::size_t row = 0; row < kJacksboroPoints; ++row) {
    const double x = static_cast<double>(take_digits(rows)) / 10;
    const double y = static_cast<double>(take_digits(rows)) / 10;
    const auto z = static_cast<double>(take_digits(rows));
    // Each subset is equally likely: a row is kept with probability (still wanted) / (rows left).
    const auto left = static_cast<std::uint32_t>(kJacksboroPoints - row);
    if (random_below(left, seed, row) < n - points.size()) {
      points.xy.push_back({x, y});
      points.z.push_back(z);
    }
  }
  return points;
}

}  // namespace hodt
