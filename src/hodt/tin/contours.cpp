#include "hodt/tin/contours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"
#include "hodt/tin/counter_clockwise.h"
#include "hodt/tin/round_number.h"

namespace hodt {

namespace {

/// An edge of the mesh that the surface crosses a level on. The end at the level or above comes
/// second, so both triangles of the edge compute the same place.
struct Crossed {
  Index low, high;
  friend bool operator==(const Crossed&, const Crossed&) = default;
  friend auto operator<=>(const Crossed&, const Crossed&) = default;
};

constexpr std::size_t kGrain = 1 << 13;

/// What a triangle has of a level: from edge to edge, with the higher part on the left.
struct Piece {
  Index level;
  Crossed from, to;
};

/// The piece of a triangle whose corners run counter-clockwise, at a level between their heights:
/// above its lowest, not above its highest.
Piece piece_of(const std::array<Index, 3>& corners, std::span<const double> z, Index level,
               double height) {
  Piece piece{level, {}, {}};
  for (int i = 0; i < 3; ++i) {
    const Index a = corners[i], b = corners[(i + 1) % 3];
    const bool a_is_low = z[a] < height, b_is_low = z[b] < height;
    // Counter-clockwise, the line comes in where the border of the triangle goes down.
    if (!a_is_low && b_is_low) piece.from = {b, a};
    if (a_is_low && !b_is_low) piece.to = {a, b};
  }
  return piece;
}

/// The levels that a triangle has a piece of: above its lowest corner, not above its highest.
std::span<const double> levels_of(const Tin& tin, std::size_t t, std::span<const double> levels) {
  const auto& [a, b, c] = tin.triangles[t];
  const std::vector<double>& z = tin.points.z;
  const auto [low, high] = std::minmax({z[a], z[b], z[c]});
  const auto first = std::upper_bound(levels.begin(), levels.end(), low);
  return {first, std::upper_bound(first, levels.end(), high)};
}

/// Throws ParameterError if there are more pieces than memory holds.
void check_pieces(const Tin& tin, std::span<const double> levels) {
  constexpr double most = 1e9;
  const double pieces =
      parallel_sum(0, tin.triangles.size(), kGrain, [&](std::size_t first, std::size_t last) {
        std::size_t count = 0;
        for (std::size_t t = first; t < last; ++t) count += levels_of(tin, t, levels).size();
        return static_cast<double>(count);
      });
  if (pieces > most)
    throw ParameterError(fmt::format(
        "contours at {} levels are {} pieces of lines, more than the {} that there may be; choose "
        "levels {} times as far apart",
        levels.size(), pieces, most, std::ceil(pieces / most)));
}

std::vector<Piece> pieces_of(const Tin& tin, std::span<const double> levels) {
  const std::vector<double>& z = tin.points.z;
  const std::vector<Point>& xy = tin.points.xy;
  return parallel_collect<Piece>(
      0, tin.triangles.size(), kGrain,
      [&](std::size_t first, std::size_t last, std::vector<Piece>& found) {
        for (std::size_t t = first; t < last; ++t) {
          const std::span<const double> crossed = levels_of(tin, t, levels);
          if (crossed.empty()) continue;
          const std::array<Index, 3> corners = counter_clockwise(xy, tin.triangles[t]);
          for (const double& level : crossed)
            found.push_back(
                piece_of(corners, z, static_cast<Index>(&level - levels.data()), level));
        }
      });
}

/// Sorts by level, and by the edges that pieces come from within one.
std::vector<std::size_t> sort_by_level(std::vector<Piece>& pieces, std::size_t levels) {
  std::vector<std::size_t> begin(levels + 1, 0);
  for (const Piece& piece : pieces) ++begin[piece.level + 1];
  for (std::size_t i = 0; i < levels; ++i) begin[i + 1] += begin[i];
  std::vector<Piece> sorted(pieces.size());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (const Piece& piece : pieces) sorted[next[piece.level]++] = piece;
  pieces = std::move(sorted);
  parallel_for(0, levels, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      std::sort(pieces.begin() + std::ptrdiff_t(begin[i]),
                pieces.begin() + std::ptrdiff_t(begin[i + 1]),
                [](const Piece& p, const Piece& q) { return p.from < q.from; });
  });
  return begin;
}

/// The pieces of one level, chained to lines.
class Chainer {
 public:
  Chainer(const Tin& tin, double level, std::span<const Piece> pieces)
      : tin_(tin), level_(level), pieces_(pieces) {}

  void append_lines(std::vector<ContourLine>& lines) const {
    for (std::size_t i = 1; i < pieces_.size(); ++i)
      if (pieces_[i].from == pieces_[i - 1].from) refuse(pieces_[i].from);
    std::vector<std::size_t> next(pieces_.size(), kEnd);
    std::vector<char> is_followed(pieces_.size(), 0), is_done(pieces_.size(), 0);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      next[i] = piece_from(pieces_[i].to);
      if (next[i] == kEnd) continue;
      if (is_followed[next[i]]) refuse(pieces_[i].to);
      is_followed[next[i]] = 1;
    }
    const auto chain = [&](std::size_t first) {
      ContourLine line{level_, {place_of(pieces_[first].from)}};
      for (std::size_t i = first; i != kEnd && !is_done[i]; i = next[i]) {
        is_done[i] = 1;
        const Point place = place_of(pieces_[i].to);
        if (place != line.xy.back()) line.xy.push_back(place);
      }
      if (line.xy.size() > 1) lines.push_back(std::move(line));
    };
    // Those that come from the border first: what is left closes.
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      if (!is_followed[i]) chain(i);
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      if (!is_done[i]) chain(i);
  }

 private:
  static constexpr std::size_t kEnd = static_cast<std::size_t>(-1);

  [[noreturn]] static void refuse(const Crossed& edge) {
    throw InputError(
        fmt::format("the edge between vertices {} and {} has more than two triangles, or two on "
                    "one side: there are no contours of such a mesh",
                    std::min(edge.low, edge.high), std::max(edge.low, edge.high)));
  }

  std::size_t piece_from(const Crossed& edge) const {
    const auto found =
        std::lower_bound(pieces_.begin(), pieces_.end(), edge,
                         [](const Piece& piece, const Crossed& e) { return piece.from < e; });
    return found == pieces_.end() || found->from != edge
               ? kEnd
               : static_cast<std::size_t>(found - pieces_.begin());
  }

  Point place_of(const Crossed& edge) const {
    const Point &low = tin_.points.xy[edge.low], &high = tin_.points.xy[edge.high];
    const double at = tin_.points.z[edge.low], to = tin_.points.z[edge.high];
    if (to == level_) return high;
    // Halves, so that no difference overflows.
    const double share = (0.5 * level_ - 0.5 * at) / (0.5 * to - 0.5 * at);
    return {std::lerp(low.x, high.x, share), std::lerp(low.y, high.y, share)};
  }

  const Tin& tin_;
  double level_;
  std::span<const Piece> pieces_;
};

void check_heights(const Tin& tin) {
  if (!tin.points.has_heights())
    throw ParameterError("contours need heights, and the mesh has none");
}

}  // namespace

std::vector<ContourLine> contours(const Tin& tin, std::span<const double> levels,
                                  const Progress& progress) {
  check_heights(tin);
  if (levels.empty()) throw ParameterError("there are no levels to draw contours at");
  for (std::size_t i = 0; i < levels.size(); ++i)
    if (!std::isfinite(levels[i]) || (i > 0 && levels[i] <= levels[i - 1]))
      throw ParameterError("the levels of contours must be finite and ascend");
  check_pieces(tin, levels);
  std::vector<Piece> pieces = pieces_of(tin, levels);
  const std::vector<std::size_t> begin = sort_by_level(pieces, levels.size());
  const auto append_lines = [&](std::size_t first, std::size_t last,
                                std::vector<ContourLine>& found) {
    for (std::size_t i = first; i < last; ++i)
      Chainer(tin, levels[i], std::span(pieces).subspan(begin[i], begin[i + 1] - begin[i]))
          .append_lines(found);
  };
  std::vector<ContourLine> lines;
  const std::size_t batch = levels.size() / 50 + 1;
  std::size_t done = 0;
  parallel_stream<ContourLine>(
      0, levels.size(), batch, 1, append_lines, [&](std::vector<ContourLine>& found) {
        lines.insert(lines.end(), std::make_move_iterator(found.begin()),
                     std::make_move_iterator(found.end()));
        done += batch;
        if (progress) progress("contours", std::min(1., double(done) / double(levels.size())));
      });
  return lines;
}

namespace {}  // namespace

std::vector<double> contour_levels(const Tin& tin, double interval, double base) {
  check_heights(tin);
  if (!(interval > 0) || !std::isfinite(interval) || !std::isfinite(base))
    throw ParameterError(
        fmt::format("the interval of contours must be a positive number, and the base a number; "
                    "they are {} and {}",
                    interval, base));
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<double> levels;
  if (tin.points.z.empty()) return levels;
  const auto [lowest, highest] = std::minmax_element(tin.points.z.begin(), tin.points.z.end());
  const double low = *lowest, high = *highest;
  const auto first_of = [&](double d) { return std::ceil(low / d - base / d) - 1; };
  const auto last_of = [&](double d) { return std::floor(high / d - base / d) + 1; };
  constexpr double kMost = 1e7;
  const auto does = [&](double d) { return !(last_of(d) - first_of(d) > kMost); };
  if (!does(interval))
    throw ParameterError(fmt::format(
        "an interval of {} makes more than the {} levels between {} and {} that there may be; "
        "choose a larger one, {} does",
        interval, kMost, low, high, next_round_number(interval, does)));
  // Beyond, base + i * interval is no longer another level for each i, and at last i + 1 is i.
  const double largest = std::max({std::fabs(low), std::fabs(high), std::fabs(base)});
  const double step = std::nextafter(largest, kInfinity) - largest;
  constexpr double kMostExact = 0x1p53;
  const auto is_told = [&](double d) {
    return d >= step && std::fabs(first_of(d)) < kMostExact && std::fabs(last_of(d)) < kMostExact;
  };
  if (!is_told(interval))
    throw ParameterError(fmt::format(
        "levels an interval of {} apart are not told apart at {}, where numbers are {} apart; "
        "choose a larger one, {} does",
        interval, largest, step,
        next_round_number(interval, [&](double d) { return does(d) && is_told(d); })));
  const double first = first_of(interval), last = last_of(interval);
  for (double i = first; i <= last; ++i) {
    const double level = base + i * interval;
    if (low <= level && level <= high && (levels.empty() || level > levels.back()))
      levels.push_back(level);
  }
  return levels;
}

}  // namespace hodt
