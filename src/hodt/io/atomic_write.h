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
  /// For libraries that make files by themselves: `make` is told a name that ends as the target's
  /// does, in an empty folder, and what it leaves there becomes all that this file holds. It may
  /// leave other files beside it, which are removed with the folder, whatever happens; but those of
  /// the same name with one of the extensions `companions`, separated by blanks, belong to the file
  /// and appear with it, and where there is none an old one goes. To be called once, in place of
  /// write().
  void fill_by_name(const std::function<void(const std::filesystem::path&)>& make,
                    std::string_view companions = {});
  /// Files whose names are the target's with one of these at the end ("x.tif.ovr"), separated by
  /// blanks, tell of an old file there, and would lie about the new one: they go when it appears.
  void outdate(std::string_view ends);
  /// Everything is on the disk, and nothing more is written: what can fail has failed by now.
  void finish();
  /// Everything is on the disk, and then at the target.
  void commit();

  /// As it was named to the constructor.
  const std::filesystem::path& path() const { return path_; }
  /// Whether a file appears at the end, in place of an old one if there is one; else every byte
  /// goes directly to where it is read.
  bool is_replaced() const { return !temporary_.empty(); }

 private:
  friend void commit_together(std::span<const std::unique_ptr<OutputFile>> files);

  void rename();
  void open_temporary();
  void keep_permissions();
  void take(const std::filesystem::path& made);
  void take_companion(const std::filesystem::path& made);
  void copy(const std::filesystem::path& made);
  void discard() noexcept;
  [[noreturn]] void fail(int error);

  std::filesystem::path path_;
  std::filesystem::path target_;
  std::filesystem::path temporary_;  ///< empty if writing directly
  int descriptor_ = -1;
  bool owns_descriptor_ = true;
  std::vector<std::unique_ptr<OutputFile>> companions_;
  std::vector<std::filesystem::path> outdated_;  ///< files beside an old one, to remove
};

/// Commits all of them, and none if one cannot be finished.
void commit_together(std::span<const std::unique_ptr<OutputFile>> files);

/// Removes the temporary files and folders of this process, for good: whoever tries to write
/// afterwards waits for ever. For a program that a signal ends; to be called by a thread, not by a
/// signal handler.
void abandon_output_files() noexcept;

/// Whether the path stands for the process's standard output: "-", /dev/stdout and the like.
bool is_standard_output(const std::filesystem::path& path);

/// What messages call it as an output.
std::string output_name(const std::filesystem::path& path);

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
