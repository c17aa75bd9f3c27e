// Formats told by a file's name.
// Tested by tests/app/faults_test.cpp.
#pragma once

#include <filesystem>
#include <string>

namespace hodt {

/// The extension in lower case.
inline std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) {
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return extension;
}

/// Whether the name ends in ".gz".
inline bool is_packed_name(const std::filesystem::path& path) {
  return lower_extension(path) == ".gz";
}

/// The extension that tells the format: ".csv" for "a.CSV.gz".
inline std::string format_extension(const std::filesystem::path& path) {
  return lower_extension(is_packed_name(path) ? path.stem() : path);
}

}  // namespace hodt
