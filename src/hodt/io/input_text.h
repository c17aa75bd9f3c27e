// A whole file in memory, unpacked.
// Tested by tests/io/point_file_test.cpp.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "hodt/base/buffer.h"

namespace hodt {

/// A path that means standard input.
inline constexpr std::string_view kStandardInput = "-";

struct InputText {
  /// Past `size` follow kPadding bytes: a line feed, so that the last line ends like the others and
  /// a number never runs on, then zeros, so that eight bytes can be read from anywhere.
  static constexpr std::size_t kPadding = 16;

  Buffer<char> bytes;
  std::size_t size = 0;
  /// What messages call it.
  std::string name;

  const char* begin() const { return bytes.data(); }
  const char* end() const { return bytes.data() + size; }
  std::string_view view() const { return {bytes.data(), size}; }
};

/// Reads all of a file ("-": standard input) and unpacks it if it is gzip, whatever its name. A
/// byte order mark is dropped, and UTF-16 that has one becomes UTF-8. Throws FileError if it cannot
/// be read, InputError if it is damaged.
InputText read_input(const std::filesystem::path& path);

/// Throws FileError if the file cannot be opened to read it.
void require_readable(const std::filesystem::path& path);

/// Throws InputError if the input is empty or is no text.
void require_text(const InputText& input);

/// What messages call the path.
std::string display_name(const std::filesystem::path& path);

}  // namespace hodt
