// The header of a LAS file, and the records before and behind its points.
// Tested by tests/io/las_test.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hodt/io/input_text.h"

namespace hodt::las {

/// A variable length record. The views are of the file.
struct Record {
  std::string_view user;
  std::uint16_t id = 0;
  std::string_view content;
};

struct LasHeader {
  std::string name;  ///< of the file, for messages
  int minor_version = 0;
  bool prefers_wkt = false;
  int format = 0;  ///< of the points
  bool is_compressed = false;
  std::size_t point_size = 0;
  std::uint64_t point_count = 0;
  std::size_t points_begin = 0;
  double scale[3] = {};
  double offset[3] = {};
  std::vector<Record> records;

  /// The content of the first such record; empty if there is none.
  std::string_view content_of(std::string_view user, std::uint16_t id) const;
};

/// Throws InputError unless the file is LAS 1.0 to 1.4 whose header and records are inside of it
/// and fit each other. That the points are there is not checked.
LasHeader parse_las_header(const InputText& input);

}  // namespace hodt::las
