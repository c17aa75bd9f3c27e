// Writes LAS files that are not compressed, by the ASPRS specification alone: it shares no code
// with the reader.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "hodt/io/input_text.h"

namespace hodt::test {

/// A point as the specification names its fields.
struct LasPoint {
  std::int32_t x = 0, y = 0, z = 0;
  int point_class = 2;
  int return_number = 1;
  int number_of_returns = 1;
  bool synthetic = false, key_point = false, withheld = false, overlap = false;
};

class LasWriter {
 public:
  LasWriter(int format, int minor_version) : format_(format), minor_version_(minor_version) {}

  double scale[3] = {0.01, 0.01, 0.001};
  double offset[3] = {0, 0, 0};
  int global_encoding = 0;
  int extra_bytes = 0;
  bool in_long_records = false;  ///< records stand behind the points
  std::uint32_t legacy_count_is_off_by = 0;
  std::vector<LasPoint> points;

  void add_record(std::string user, int id, std::string content) {
    records_.push_back({std::move(user), id, std::move(content)});
  }

  std::string bytes() const {
    std::string file(header_size(), '\0');
    std::string records, long_records;
    for (const Record& record : records_)
      (in_long_records ? long_records : records) += bytes_of(record);
    const std::size_t begin = file.size() + records.size();
    std::string body;
    for (const LasPoint& point : points) body += bytes_of(point);
    fill_header(file, begin, begin + body.size());
    return file + records + body + long_records;
  }

 private:
  struct Record {
    std::string user;
    int id;
    std::string content;
  };

  /// 227 bytes, of LAS 1.3 eight more for waveforms, of LAS 1.4 140 more.
  std::size_t header_size() const {
    return minor_version_ >= 4 ? 375 : minor_version_ == 3 ? 235 : 227;
  }

  std::size_t point_size() const {
    constexpr std::size_t sizes[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
    return sizes[format_] + static_cast<std::size_t>(extra_bytes);
  }

  static void put(std::string& bytes, std::size_t at, std::uint64_t number, int size) {
    for (int i = 0; i < size; ++i)
      bytes[at + static_cast<std::size_t>(i)] = static_cast<char>(number >> (8 * i) & 255);
  }

  /// The bits of a double by its definition.
  static std::uint64_t bits_of(double value) {
    if (value == 0) return 0;
    int exponent = 0;
    const double mantissa = std::frexp(std::fabs(value), &exponent);
    const auto digits = static_cast<std::uint64_t>(std::ldexp(mantissa, 53));
    return (value < 0 ? std::uint64_t{1} << 63 : 0) |
           static_cast<std::uint64_t>(exponent + 1022) << 52 |
           (digits & ((std::uint64_t{1} << 52) - 1));
  }

  void fill_header(std::string& file, std::size_t begin, std::size_t end) const {
    file.replace(0, 4, "LASF");
    put(file, 6, static_cast<std::uint64_t>(global_encoding), 2);
    put(file, 24, 1, 1);
    put(file, 25, static_cast<std::uint64_t>(minor_version_), 1);
    put(file, 94, file.size(), 2);
    put(file, 96, begin, 4);
    put(file, 100, in_long_records ? 0 : records_.size(), 4);
    put(file, 104, static_cast<std::uint64_t>(format_), 1);
    put(file, 105, point_size(), 2);
    // New formats have no count in the old place.
    const std::uint64_t legacy = format_ < 6 ? points.size() + legacy_count_is_off_by : 0;
    put(file, 107, legacy, 4);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      put(file, 131 + 8 * axis, bits_of(scale[axis]), 8);
      put(file, 155 + 8 * axis, bits_of(offset[axis]), 8);
    }
    if (minor_version_ < 4) return;
    put(file, 235, in_long_records ? end : 0, 8);
    put(file, 243, in_long_records ? records_.size() : 0, 4);
    put(file, 247, points.size(), 8);
  }

  std::string bytes_of(const Record& record) const {
    std::string bytes(in_long_records ? 60 : 54, '\0');
    bytes.replace(2, record.user.size(), record.user);
    put(bytes, 18, static_cast<std::uint64_t>(record.id), 2);
    put(bytes, 20, record.content.size(), in_long_records ? 8 : 2);
    return bytes + record.content;
  }

  std::string bytes_of(const LasPoint& p) const {
    std::string bytes(point_size(), '\x55');
    put(bytes, 0, static_cast<std::uint32_t>(p.x), 4);
    put(bytes, 4, static_cast<std::uint32_t>(p.y), 4);
    put(bytes, 8, static_cast<std::uint32_t>(p.z), 4);
    const auto number = static_cast<unsigned>(p.return_number);
    const auto count = static_cast<unsigned>(p.number_of_returns);
    const auto point_class = static_cast<unsigned>(p.point_class);
    const auto bit = [](bool is_set, int i) { return is_set ? 1u << i : 0u; };
    const unsigned flags = bit(p.synthetic, 0) | bit(p.key_point, 1) | bit(p.withheld, 2);
    if (format_ < 6) {
      put(bytes, 14, number | count << 3 | 1u << 7, 1);
      put(bytes, 15, point_class | flags << 5, 1);
    } else {
      put(bytes, 14, number | count << 4, 1);
      put(bytes, 15, flags | bit(p.overlap, 3) | 2u << 4 | 1u << 6, 1);
      put(bytes, 16, point_class, 1);
    }
    return bytes;
  }

  int format_;
  int minor_version_;
  std::vector<Record> records_;
};

/// As read_input() would give it.
inline InputText input_of(const std::string& bytes, std::string name = "cloud.las") {
  InputText input;
  input.bytes = Buffer<char>(bytes.size() + InputText::kPadding, '\0');
  std::copy(bytes.begin(), bytes.end(), input.bytes.data());
  input.bytes[bytes.size()] = '\n';
  input.size = bytes.size();
  input.name = std::move(name);
  return input;
}

}  // namespace hodt::test
