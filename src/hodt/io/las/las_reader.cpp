#include "hodt/io/las/las_reader.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bitset>
#include <cstddef>
#include <functional>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/base/ids.h"
#include "hodt/base/parallel.h"
#include "hodt/io/las/chunk_decoder.h"
#include "hodt/io/las/chunk_table.h"
#include "hodt/io/las/damage.h"
#include "hodt/io/las/las_crs.h"
#include "hodt/io/las/las_header.h"
#include "hodt/io/las/laz_layout.h"
#include "hodt/io/las/raw_point.h"

namespace hodt {

namespace {

using namespace las;

constexpr std::size_t kGround = 2;

/// Points that are not compressed.
class PlainDecoder final : public ChunkDecoder {
 public:
  explicit PlainDecoder(const LasHeader& header)
      : point_size_(header.point_size), is_long_(header.format >= kFirstLongFormat) {}

  void decode(const Chunk& chunk, std::vector<RawPoint>& points) override {
    for (const char* from = chunk.begin; from < chunk.end; from += point_size_)
      points.push_back(raw_point(from, is_long_));
  }

 private:
  std::size_t point_size_;
  bool is_long_;
};

std::vector<Chunk> cut_plain_points(const InputText& input, const LasHeader& header) {
  const std::size_t room = (input.size - header.points_begin) / header.point_size;
  if (room < header.point_count)
    throw InputError(
        fmt::format("{}: its header says that there are {} points, and the file ends in point {} "
                    "at byte {}; it is cut short",
                    input.name, header.point_count, room + 1, input.size));
  constexpr std::size_t most = 50000;
  std::vector<Chunk> chunks;
  const char* from = input.begin() + header.points_begin;
  for (std::size_t left = header.point_count; left > 0;) {
    const std::size_t count = std::min(left, most);
    chunks.push_back({from, from + count * header.point_size, count});
    from = chunks.back().end;
    left -= count;
  }
  return chunks;
}

using ClassCounts = std::array<std::uint64_t, LasChoice::kClasses>;

/// The same, added up by all threads.
class SharedClassCounts {
 public:
  void add(const ClassCounts& counts) {
    for (std::size_t c = 0; c < counts.size(); ++c)
      if (counts[c] > 0) sums_[c].fetch_add(counts[c], std::memory_order_relaxed);
  }
  ClassCounts get() const {
    ClassCounts counts;
    std::copy(sums_.begin(), sums_.end(), counts.begin());
    return counts;
  }

 private:
  std::array<std::atomic<std::uint64_t>, LasChoice::kClasses> sums_{};
};

/// What a chunk became. There may be as many as points, so this is small.
struct DecodedChunk {
  std::vector<RawPoint> points;
  std::size_t read = 0;
  std::size_t taken = 0;
  std::size_t begin = 0;  ///< of its points among all that are taken
  std::string damage;
};

class Reader {
 public:
  Reader(const InputText& input, const LasChoice& choice)
      : input_(input), choice_(choice), header_(parse_las_header(input)) {
    if (header_.is_compressed) {
      constexpr std::uint16_t record = 22204;
      layout_ = parse_laz_layout(header_, header_.content_of("laszip encoded", record));
      chunks_ = read_chunk_table(input, header_, layout_);
    } else {
      chunks_ = cut_plain_points(input, header_);
    }
  }

  LasPoints read() {
    decode();
    choose();
    place();
    points_.crs = crs_of(header_);
    return {std::move(points_), heights_of(header_), counts_};
  }

 private:
  std::unique_ptr<ChunkDecoder> decoder() const {
    if (!header_.is_compressed) return std::make_unique<PlainDecoder>(header_);
    if (header_.format >= kFirstLongFormat) return make_layered_decoder(layout_);
    return make_pointwise_decoder(layout_);
  }

  template <class F>
  void for_each_chunk(const F& f) {
    parallel_for(0, chunks_.size(), 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) f(i);
    });
  }

  void decode() {
    decoded_.resize(chunks_.size());
    PerThread<std::unique_ptr<ChunkDecoder>> decoders([&] { return decoder(); });
    SharedClassCounts of_class;
    for_each_chunk([&](std::size_t i) {
      decode(*decoders.mine(), chunks_[i], decoded_[i]);
      of_class.add(count_classes(decoded_[i]));
    });
    std::size_t before = 0;
    for (std::size_t i = 0; i < chunks_.size(); ++i) {
      if (!decoded_[i].damage.empty()) fail(i, before);
      before += chunks_[i].points;
    }
    counts_.of_class = of_class.get();
    counts_.total = header_.point_count;
    counts_.withheld = std::accumulate(counts_.of_class.begin(), counts_.of_class.end(),
                                       counts_.total, std::minus<>());
  }

  static void decode(ChunkDecoder& decoder, const Chunk& chunk, DecodedChunk& decoded) {
    // A point may take less than a byte, but seldom does: more room is made as they come.
    const auto bytes = static_cast<std::size_t>(chunk.end - chunk.begin);
    decoded.points.reserve(std::min(chunk.points, bytes));
    try {
      decoder.decode(chunk, decoded.points);
    } catch (const Damage& damage) {
      decoded.damage = damage.what;
    }
    decoded.read = decoded.points.size();
    if (!decoded.damage.empty()) decoded.points = {};
  }

  /// Of points that are not withheld.
  static ClassCounts count_classes(const DecodedChunk& chunk) {
    ClassCounts counts{};
    for (const RawPoint& point : chunk.points)
      if (!point.withheld) ++counts[point.point_class];
    return counts;
  }

  /// The first chunk that is damaged, whichever was seen first.
  [[noreturn]] void fail(std::size_t i, std::size_t points_before) const {
    throw InputError(
        fmt::format("{}: chunk {} of {}, which begins at byte {}, is damaged after point {}: {}",
                    input_.name, i + 1, chunks_.size(), chunks_[i].begin - input_.begin(),
                    points_before + decoded_[i].read, decoded_[i].damage));
  }

  /// Which classes, and which points of each chunk.
  void choose() {
    classes_ = choice_.listed;
    const bool has_ground = counts_.of_class[kGround] > 0;
    if (choice_.classes == LasChoice::Classes::automatic) classes_.reset().set(kGround);
    counts_.all_classes = choice_.classes == LasChoice::Classes::all ||
                          (choice_.classes == LasChoice::Classes::automatic && !has_ground);
    if (counts_.all_classes) classes_.set();
    counts_.returns = choice_.returns;
    SharedClassCounts taken_of_class;
    for_each_chunk([&](std::size_t i) { taken_of_class.add(count_taken(decoded_[i])); });
    counts_.taken_of_class = taken_of_class.get();
    for (DecodedChunk& chunk : decoded_) {
      chunk.begin = counts_.taken;
      counts_.taken += chunk.taken;
    }
    for (std::size_t c = 0; c < LasChoice::kClasses; ++c)
      (classes_[c] ? counts_.other_return : counts_.other_class) +=
          counts_.of_class[c] - counts_.taken_of_class[c];
    if (counts_.taken == 0) throw_none();
    if (counts_.taken >= kNone)
      throw InputError(
          fmt::format("{} has more points than hodt can number ({})", input_.name, kNone));
  }

  bool is_taken(const RawPoint& point) const {
    if (point.withheld || !classes_[point.point_class]) return false;
    if (choice_.returns == LasChoice::Returns::first) return point.first_return;
    return choice_.returns != LasChoice::Returns::last || point.last_return;
  }

  ClassCounts count_taken(DecodedChunk& chunk) const {
    ClassCounts counts{};
    for (const RawPoint& point : chunk.points) {
      if (!is_taken(point)) continue;
      ++counts[point.point_class];
      ++chunk.taken;
    }
    return counts;
  }

  [[noreturn]] void throw_none() const {
    std::string classes;
    for (std::size_t c = 0; c < LasChoice::kClasses; ++c) {
      if (counts_.of_class[c] == 0) continue;
      classes += fmt::format("{}{}", classes.empty() ? "" : ", ", las_class_name(c));
    }
    throw InputError(fmt::format(
        "{}: none of its {} points is of the classes and returns asked for; {} withheld, the "
        "others are of class {}",
        input_.name, counts_.total, counts_.withheld, classes.empty() ? "none" : classes));
  }

  void place() {
    points_.xy.resize(counts_.taken);
    points_.z.resize(counts_.taken);
    for_each_chunk([&](std::size_t i) {
      std::size_t at = decoded_[i].begin;
      for (const RawPoint& point : decoded_[i].points) {
        if (!is_taken(point)) continue;
        points_.xy[at] = {coordinate(point.x, 0), coordinate(point.y, 1)};
        points_.z[at] = coordinate(point.z, 2);
        ++at;
      }
      decoded_[i].points = {};
    });
  }

  double coordinate(std::int32_t stored, std::size_t axis) const {
    return stored * header_.scale[axis] + header_.offset[axis];
  }

  const InputText& input_;
  const LasChoice& choice_;
  LasHeader header_;
  LazLayout layout_;
  std::vector<Chunk> chunks_;
  std::vector<DecodedChunk> decoded_;
  std::bitset<LasChoice::kClasses> classes_;
  LasCounts counts_;
  PointSet points_;
};

}  // namespace

bool is_las(std::string_view bytes) {
  return bytes.starts_with("LASF");
}

LasPoints read_las(const InputText& input, const LasChoice& choice) {
  return Reader(input, choice).read();
}

std::string text_of(const LasCounts& counts) {
  std::string classes;
  for (std::size_t c = 0; c < LasChoice::kClasses && !counts.all_classes; ++c)
    if (counts.taken_of_class[c] > 0)
      classes += fmt::format("{}{}", classes.empty() ? "" : ", ", las_class_name(c));
  std::string text = counts.all_classes ? "all classes" : "class " + classes;
  if (counts.returns == LasChoice::Returns::first) text += ", first returns";
  if (counts.returns == LasChoice::Returns::last) text += ", last returns";
  text += fmt::format(": {} of {} points", counts.taken, counts.total);
  if (counts.withheld > 0) text += fmt::format(", {} withheld", counts.withheld);
  return text;
}

}  // namespace hodt
