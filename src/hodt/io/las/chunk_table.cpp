#include "hodt/io/las/chunk_table.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/las/integer_decoder.h"
#include "hodt/io/las/little_endian.h"

namespace hodt::las {

namespace {

class TableReader {
 public:
  TableReader(const InputText& input, const LasHeader& header, const LazLayout& layout)
      : input_(input), header_(header), layout_(layout) {}

  std::vector<Chunk> read() {
    if (layout_.compressor == LazLayout::pointwise) return {whole()};
    find_table();
    try {
      read_entries();
    } catch (const Damage& damage) {
      fail(damage.what);
    }
    check_total();
    return std::move(chunks_);
  }

 private:
  static constexpr std::size_t kPlaceSize = 8, kTableHeader = 8;

  [[noreturn]] void fail(std::string_view why) const {
    throw InputError(fmt::format("{}: its table of chunks cannot be read: {}; the file is damaged",
                                 input_.name, why));
  }

  /// Points that are not in chunks.
  Chunk whole() const {
    if (input_.size - header_.points_begin < header_.point_size)
      throw InputError(
          fmt::format("{}: the file ends before its first point; it is cut short", input_.name));
    return {input_.begin() + header_.points_begin, input_.end(), header_.point_count};
  }

  /// The place of the table stands before the first chunk. Who could not go back to write it there
  /// wrote it at the very end.
  void find_table() {
    const std::size_t begin = header_.points_begin;
    if (input_.size - begin < kPlaceSize + kTableHeader) fail_missing();
    const std::size_t first = begin + kPlaceSize, last = input_.size - kTableHeader;
    table_ = number_at<std::uint64_t>(input_.begin() + begin);
    if (table_ == std::numeric_limits<std::uint64_t>::max())
      table_ = number_at<std::uint64_t>(input_.end() - kPlaceSize);
    if (table_ < first || table_ > last) fail_missing();
  }

  [[noreturn]] void fail_missing() const {
    throw InputError(
        fmt::format("{}: its table of chunks, which comes last, is not there; the file is cut "
                    "short or was not written to its end",
                    input_.name));
  }

  void read_entries() {
    const char* const table = input_.begin() + table_;
    if (number_at<std::uint32_t>(table) != 0)
      fail(fmt::format("it is of version {}", number_at<std::uint32_t>(table)));
    const auto count = number_at<std::uint32_t>(table + 4);
    ArithmeticDecoder in;
    if (count > 0) in = ArithmeticDecoder(table + kTableHeader, input_.end());
    IntegerDecoder<32, 2> numbers;
    const bool is_variable = layout_.chunk_points == LazLayout::kVariable;
    std::int32_t points = 0, bytes = 0;
    const char* begin = input_.begin() + header_.points_begin + kPlaceSize;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (is_variable) points = numbers.next(in, points, 0);
      bytes = numbers.next(in, bytes, 1);
      const std::size_t size = static_cast<std::uint32_t>(bytes);
      if (is_variable && points == 0 && bytes == 0) continue;
      const std::size_t holds = is_variable ? static_cast<std::uint32_t>(points)
                                            : std::min<std::uint64_t>(layout_.chunk_points, left());
      add({begin, begin + size, holds}, size);
      begin += size;
    }
  }

  std::uint64_t left() const { return header_.point_count - total_; }

  void add(const Chunk& chunk, std::size_t size) {
    const auto number = chunks_.size() + 1;
    const auto before_table = static_cast<std::size_t>(input_.begin() + table_ - chunk.begin);
    if (size > before_table)
      fail(fmt::format("chunk {} would end {} bytes behind where the table begins", number,
                       size - before_table));
    if (size < layout_.point_size)
      fail(fmt::format("chunk {} of {} bytes holds no point", number, size));
    if (chunk.points == 0 || chunk.points > left())
      fail(fmt::format("chunk {} has {} points, and all of them {}", number, chunk.points,
                       header_.point_count));
    total_ += chunk.points;
    chunks_.push_back(chunk);
  }

  void check_total() const {
    if (left() > 0)
      fail(fmt::format("its chunks have {} points, and the header says {}", total_,
                       header_.point_count));
  }

  const InputText& input_;
  const LasHeader& header_;
  const LazLayout& layout_;
  std::size_t table_ = 0;
  std::uint64_t total_ = 0;
  std::vector<Chunk> chunks_;
};

}  // namespace

std::vector<Chunk> read_chunk_table(const InputText& input, const LasHeader& header,
                                    const LazLayout& layout) {
  return TableReader(input, header, layout).read();
}

}  // namespace hodt::las
