#include "hodt/io/las/las_header.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/las/little_endian.h"
#include "hodt/io/las/raw_point.h"

namespace hodt::las {

namespace {

class HeaderParser {
 public:
  explicit HeaderParser(const InputText& input) : input_(input) { header_.name = input.name; }

  LasHeader parse() {
    parse_version();
    parse_points();
    parse_places();
    constexpr std::size_t short_header = 54, long_header = 60;
    parse_records(at<std::uint16_t>(94), at<std::uint32_t>(100), short_header,
                  header_.points_begin);
    if (header_.minor_version >= 4) {
      const auto begin = at<std::uint64_t>(235);
      if (const auto count = at<std::uint32_t>(243)) {
        if (begin > input_.size) fail_record(0, begin);
        parse_records(begin, count, long_header, input_.size);
      }
    }
    return std::move(header_);
  }

 private:
  static constexpr std::size_t kHeaderSize = 227, kHeaderSize14 = 375;

  template <class... Args>
  [[noreturn]] void fail(fmt::format_string<Args...> format, Args&&... args) const {
    throw InputError(
        fmt::format("{}: {}", input_.name, fmt::format(format, std::forward<Args>(args)...)));
  }
  [[noreturn]] void fail_record(std::size_t i, std::size_t begin) const {
    fail("record {} at byte {} does not fit into the file; the file is damaged or cut short", i + 1,
         begin);
  }

  template <class T>
  T at(std::size_t place) const {
    return number_at<T>(input_.begin() + place);
  }

  void parse_version() {
    if (input_.size < kHeaderSize)
      fail("its header ends at byte {}, and none is shorter than {} bytes; the file is cut short",
           input_.size, kHeaderSize);
    const int major = at<std::uint8_t>(24);
    header_.minor_version = at<std::uint8_t>(25);
    if (major != 1 || header_.minor_version > 4)
      fail("LAS {}.{}, and hodt reads LAS 1.0 to 1.4", major, header_.minor_version);
    const std::size_t least = header_.minor_version >= 4 ? kHeaderSize14 : kHeaderSize;
    const std::size_t size = at<std::uint16_t>(94);
    header_.points_begin = at<std::uint32_t>(96);
    if (size < least || size > header_.points_begin)
      fail(
          "the header of LAS 1.{} says that it has {} bytes, and that points begin at byte {}; the "
          "file is damaged",
          header_.minor_version, size, header_.points_begin);
    if (header_.points_begin > input_.size)
      fail("its points begin at byte {}, and the file ends at byte {}; it is cut short",
           header_.points_begin, input_.size);
    header_.prefers_wkt = (at<std::uint16_t>(6) & 16u) != 0;
  }

  void parse_points() {
    // LASzip marks compressed points by the highest bit.
    constexpr unsigned compressed = 128, marks = 192;
    const unsigned format = at<std::uint8_t>(104);
    header_.is_compressed = (format & compressed) != 0;
    header_.format = static_cast<int>(format & ~marks);
    if (header_.format >= kPointFormats)
      fail("point format {}, and hodt reads formats 0 to {}", header_.format, kPointFormats - 1);
    header_.point_size = at<std::uint16_t>(105);
    if (header_.point_size < kPointSizes[header_.format])
      fail("its points have {} bytes, and those of format {} at least {}; the file is damaged",
           header_.point_size, header_.format, kPointSizes[header_.format]);
    header_.point_count = at<std::uint32_t>(107);
    if (header_.minor_version >= 4)
      if (const auto count = at<std::uint64_t>(247)) header_.point_count = count;
    if (header_.point_count == 0) fail("its header says that there is no point");
  }

  void parse_places() {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double scale = header_.scale[axis] = at<double>(131 + 8 * axis);
      const double offset = header_.offset[axis] = at<double>(155 + 8 * axis);
      constexpr double most = 2147483648.0;  // of an int32's size
      if (scale == 0 || !std::isfinite(most * std::fabs(scale) + std::fabs(offset)))
        fail("its header gives {} the scale {} and the offset {}; the file is damaged", "xyz"[axis],
             scale, offset);
    }
  }

  void parse_records(std::size_t begin, std::size_t count, std::size_t header_size,
                     std::size_t end) {
    constexpr std::size_t user_size = 16;
    for (std::size_t i = 0; i < count; ++i) {
      if (end - begin < header_size) fail_record(i, begin);
      const std::uint64_t size =
          header_size == 60 ? at<std::uint64_t>(begin + 20) : at<std::uint16_t>(begin + 20);
      if (end - begin - header_size < size) fail_record(i, begin);
      std::string_view user = input_.view().substr(begin + 2, user_size);
      user = user.substr(0, std::min(user.find('\0'), user.size()));
      header_.records.push_back(
          {user, at<std::uint16_t>(begin + 18), input_.view().substr(begin + header_size, size)});
      begin += header_size + size;
    }
  }

  const InputText& input_;
  LasHeader header_;
};

}  // namespace

std::string_view LasHeader::content_of(std::string_view user, std::uint16_t id) const {
  const auto fits = [&](const Record& record) { return record.user == user && record.id == id; };
  const auto found = std::find_if(records.begin(), records.end(), fits);
  return found == records.end() ? std::string_view() : found->content;
}

LasHeader parse_las_header(const InputText& input) {
  return HeaderParser(input).parse();
}

}  // namespace hodt::las
