// What the operating system said of a file, by its number, for programs that decide by it.
// Tested by tests/io/atomic_write_test.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "hodt/base/error.h"

namespace hodt {

class SystemFileError : public FileError {
 public:
  SystemFileError(const std::string& message, int number, std::filesystem::path file)
      : FileError(message), number_(number), file_(std::move(file)) {}

  /// As errno has it: ENOENT, EACCES.
  int number() const { return number_; }
  const std::filesystem::path& file() const { return file_; }

 private:
  int number_;
  std::filesystem::path file_;
};

}  // namespace hodt
