// Files that appear complete or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "hodt/base/error.h"

namespace hodt {

/// Whoever read our output has closed it: no failure of ours, but there is no use in going on.
class BrokenPipeError : public FileError {
  using FileError::FileError;
};

/// A file being written beside its target, under a temporary name, until commit() renames it.
/// Before that, and forever if anything fails, whatever was at the target stays as it was. Targets
/// that are no regular files (/dev/null, a pipe, "-" for standard output) are written directly.
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes);
  /// Everything is on the disk, and then at the target.
  void commit();

 private:
  void open_temporary();
  void close();
  void discard() noexcept;
  [[noreturn]] void fail(int error);

  std::filesystem::path target_;
  std::filesystem::path temporary_;  ///< empty if writing directly
  int descriptor_ = -1;
  bool owns_descriptor_ = true;
};

/// Writes a whole file through OutputFile. Throws FileError (and what `fill` throws).
void atomic_write(const std::filesystem::path& path, std::string_view bytes);
void atomic_write(const std::filesystem::path& path, const std::function<void(OutputFile&)>& fill);

/// Throws FileError if a file cannot be written there, as far as that shows beforehand: so that a
/// long computation fails before it starts.
void check_writable(const std::filesystem::path& path);

}  // namespace hodt
