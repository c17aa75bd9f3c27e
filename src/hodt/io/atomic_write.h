// Files that appear complete or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hodt/base/error.h"

namespace hodt {

/// Whoever read our output has closed it: no failure of ours, but there is no use in going on.
class BrokenPipeError : public FileError {
  using FileError::FileError;
};

/// A file being written beside its target, under a temporary name, until commit() renames it.
/// Before that, and forever if anything fails, whatever was at the target stays as it was. Targets
/// that are no regular files (/dev/null, a pipe, "-" for standard output) are written directly. A
/// symbolic link stays, and what it leads to is written.
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes);
  /// In place of write(): for a library that insists on a path. `fill` gets a path of the target's
  /// name in a folder that is there for it alone. What it leaves there becomes the file; it may
  /// leave others of the same name with other extensions beside it, which appear with the file.
  /// Such companions of the target as have one of the `extensions`, each with its dot and separated
  /// by blanks, and are not left there again, go away when the file appears.
  void fill(const std::function<void(const std::filesystem::path&)>& fill,
            std::string_view extensions = {});
  /// Everything is on the disk, and nothing more is written: what can fail has failed by now.
  void finish();
  /// Everything is on the disk, and then at the target.
  void commit();

  /// As it was named to the constructor.
  const std::filesystem::path& path() const { return path_; }

 private:
  friend void commit_together(std::span<const std::unique_ptr<OutputFile>> files);

  void rename();
  void open_temporary();
  void take(const std::filesystem::path& made);
  void take_companions(const std::filesystem::path& folder, std::string_view extensions);
  void discard() noexcept;
  [[noreturn]] void fail(int error);

  std::filesystem::path path_;
  std::filesystem::path target_;
  std::filesystem::path temporary_;  ///< empty if writing directly
  int descriptor_ = -1;
  bool owns_descriptor_ = true;
  std::vector<std::unique_ptr<OutputFile>> companions_;
  std::vector<std::filesystem::path> outdated_;  ///< companions that go away
};

/// Commits all of them, and none if one cannot be finished.
void commit_together(std::span<const std::unique_ptr<OutputFile>> files);

/// Removes the temporary files of this process, for good: whoever tries to write afterwards waits
/// for ever. For a program that a signal ends; to be called by a thread, not by a signal handler.
void abandon_output_files() noexcept;

/// Whether the path stands for the process's standard output: "-", /dev/stdout and the like.
bool is_standard_output(const std::filesystem::path& path);

/// Where a chain of symbolic links ends, whether or not anything is there. Throws FileError if it
/// has no end.
std::filesystem::path follow_links(const std::filesystem::path& path);

/// Writes a whole file through OutputFile. Throws FileError (and what `fill` throws).
void atomic_write(const std::filesystem::path& path, std::string_view bytes);
void atomic_write(const std::filesystem::path& path, const std::function<void(OutputFile&)>& fill);

/// Throws FileError if a file cannot be written there, as far as that shows beforehand: so that a
/// long computation fails before it starts.
void check_writable(const std::filesystem::path& path);

}  // namespace hodt
