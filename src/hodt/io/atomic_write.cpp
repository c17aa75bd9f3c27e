#include "hodt/io/atomic_write.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <mutex>
#include <set>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "hodt/io/system_file_error.h"

namespace hodt {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why) {
  throw FileError(fmt::format("cannot write {}: {}", output_name(path), why));
}
[[noreturn]] void refuse(const std::filesystem::path& path, int error, const std::string& why) {
  throw SystemFileError(fmt::format("cannot write {}: {}", output_name(path), why), error, path);
}
[[noreturn]] void refuse(const std::filesystem::path& path, int error) {
  refuse(path, error, std::strerror(error));
}

/// The temporary files that there are. Their names change under the lock.
struct TemporaryFiles {
  std::recursive_mutex mutex;  // a failure under the lock removes its file
  std::set<std::filesystem::path> names;
};

TemporaryFiles& temporary_files() {
  static auto* const all = new TemporaryFiles;  // outlives every file
  return *all;
}

/// Devices and the process's own descriptors are what they are: nothing to rename. (A descriptor
/// can lead to a regular file, so its name decides; files in /dev/shm are files like any other.)
bool written_directly(const std::filesystem::path& path) {
  const std::string& name = path.native();
  for (const std::string_view descriptors : {"/dev/fd/", "/dev/stderr", "/proc/"}) {
    if (name.starts_with(descriptors)) return true;
  }
  struct stat status;
  return ::stat(name.c_str(), &status) == 0 && !S_ISREG(status.st_mode);
}

std::filesystem::path directory_of(const std::filesystem::path& path) {
  return path.has_parent_path() ? path.parent_path() : ".";
}

/// A name that no other process and no other file of this one has.
std::filesystem::path temporary_name(const std::filesystem::path& target) {
  static std::atomic<unsigned> count{0};
  // Leaves room for the suffix where the target's name is as long as names may be.
  const std::string stem = target.filename().string().substr(0, 200);
  return directory_of(target) / fmt::format(".{}.{}-{}.tmp", stem, ::getpid(), count++);
}

int open_retrying(const std::filesystem::path& path, int flags) {
  int descriptor = -1;
  do {
    descriptor = ::open(path.c_str(), flags | O_CLOEXEC, 0666);
  } while (descriptor < 0 && errno == EINTR);
  return descriptor;
}

/// An empty folder, for a while.
class TemporaryFolder {
 public:
  /// Beside the target, or where temporary files are if that is a device or a pipe.
  TemporaryFolder(const std::filesystem::path& target, bool is_beside) {
    const std::filesystem::path like =
        is_beside ? target : std::filesystem::temp_directory_path() / target.filename();
    TemporaryFiles& others = temporary_files();
    const std::unique_lock lock(others.mutex);
    do {
      path_ = temporary_name(like);
      if (::mkdir(path_.c_str(), 0700) == 0) break;
      if (errno != EEXIST) refuse(path_, errno);
    } while (true);
    others.names.insert(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
    const std::unique_lock lock(temporary_files().mutex);
    temporary_files().names.erase(path_);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

OutputFile::OutputFile(const std::filesystem::path& path) : path_(path), target_(path) {
  check_writable(path);
  if (is_standard_output(path)) {
    descriptor_ = STDOUT_FILENO;
    owns_descriptor_ = false;
  } else if (written_directly(path)) {
    descriptor_ = open_retrying(path, O_WRONLY | O_APPEND);
    if (descriptor_ < 0) fail(errno);
  } else {
    open_temporary();
  }
}

OutputFile::~OutputFile() {
  discard();
}

void OutputFile::open_temporary() {
  target_ = follow_links(target_);
  TemporaryFiles& others = temporary_files();
  const std::unique_lock lock(others.mutex);
  std::filesystem::path name;
  do {
    name = temporary_name(target_);
    descriptor_ = open_retrying(name, O_WRONLY | O_CREAT | O_EXCL);
  } while (descriptor_ < 0 && errno == EEXIST);
  if (descriptor_ < 0) fail(errno);
  temporary_ = name;
  others.names.insert(name);
  keep_permissions();
}

/// A file that is replaced keeps its permissions; a new one has the usual ones already.
void OutputFile::keep_permissions() {
  struct stat status;
  if (::stat(target_.c_str(), &status) == 0 && ::fchmod(descriptor_, status.st_mode & 07777) != 0) {
    fail(errno);
  }
}

void OutputFile::write(std::string_view bytes) {
  constexpr std::size_t largest = std::size_t{1} << 30;
  while (!bytes.empty()) {
    const auto written = ::write(descriptor_, bytes.data(), std::min(bytes.size(), largest));
    if (written > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    } else if (written == 0) {
      fail(ENOSPC);
    } else if (errno != EINTR) {
      fail(errno);
    }
  }
}

void OutputFile::fill_by_name(const std::function<void(const std::filesystem::path&)>& make,
                              std::string_view companions) {
  const TemporaryFolder folder(target_, !temporary_.empty());
  const std::filesystem::path made = folder.path() / target_.filename();
  make(made);
  if (temporary_.empty()) {
    copy(made);
  } else {
    take(made);
    std::istringstream extensions{std::string(companions)};
    for (std::string extension; extensions >> extension;)
      take_companion(std::filesystem::path(made).replace_extension(extension));
  }
}

void OutputFile::take_companion(const std::filesystem::path& made) {
  const std::filesystem::path place = directory_of(target_) / made.filename();
  if (std::filesystem::exists(made)) {
    companions_.push_back(std::make_unique<OutputFile>(place));
    companions_.back()->take(made);
  } else {
    outdated_.push_back(place);
  }
}

void OutputFile::outdate(std::string_view ends) {
  std::istringstream all{std::string(ends)};
  for (std::string end; all >> end;) outdated_.emplace_back(target_.native() + end);
}

/// Takes the place of the temporary file.
void OutputFile::take(const std::filesystem::path& made) {
  {
    const std::unique_lock lock(temporary_files().mutex);
    if (::rename(made.c_str(), temporary_.c_str()) != 0) fail(errno);
  }
  ::close(std::exchange(descriptor_, -1));
  descriptor_ = open_retrying(temporary_, O_WRONLY | O_APPEND);
  if (descriptor_ < 0) fail(errno);
  keep_permissions();
}

void OutputFile::copy(const std::filesystem::path& made) {
  std::ifstream stream(made, std::ios::binary);
  std::vector<char> piece(std::size_t{1} << 20);
  while (stream) {
    stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    write({piece.data(), static_cast<std::size_t>(stream.gcount())});
  }
  if (!stream.eof()) refuse(path_, "what was made for it cannot be read: " + made.string());
}

void OutputFile::finish() {
  for (const auto& file : companions_) file->finish();
  if (descriptor_ < 0) return;
  // Some file systems have nothing to synchronise and say so.
  if (!temporary_.empty() && ::fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOTSUP)
    fail(errno);
  const int descriptor = std::exchange(descriptor_, -1);
  if (owns_descriptor_ && ::close(descriptor) != 0 && errno != EINTR) fail(errno);
}

void OutputFile::commit() {
  finish();
  const std::unique_lock lock(temporary_files().mutex);
  rename();
}

/// REQUIRES the lock of the temporary files.
void OutputFile::rename() {
  if (temporary_.empty()) return;
  for (const auto& file : companions_) file->rename();
  for (const std::filesystem::path& old : outdated_) ::unlink(old.c_str());
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_files().names.erase(temporary_);
  temporary_.clear();
}

void OutputFile::discard() noexcept {
  const int descriptor = std::exchange(descriptor_, -1);
  if (descriptor >= 0 && owns_descriptor_) ::close(descriptor);
  if (temporary_.empty()) return;
  ::unlink(temporary_.c_str());
  const std::unique_lock lock(temporary_files().mutex);
  temporary_files().names.erase(temporary_);
  temporary_.clear();
}

void OutputFile::fail(int error) {
  discard();
  const std::string message =
      fmt::format("cannot write {}: {}", output_name(target_), std::strerror(error));
  if (error == EPIPE) throw BrokenPipeError(message);
  throw SystemFileError(message, error, target_);
}

void atomic_write(const std::filesystem::path& path, std::string_view bytes) {
  atomic_write(path, [bytes](OutputFile& file) { file.write(bytes); });
}

void atomic_write(const std::filesystem::path& path, const std::function<void(OutputFile&)>& fill) {
  OutputFile file(path);
  fill(file);
  file.commit();
}

void commit_together(std::span<const std::unique_ptr<OutputFile>> files) {
  for (const auto& file : files) file->finish();
  const std::unique_lock lock(temporary_files().mutex);
  for (const auto& file : files) file->rename();
}

void abandon_output_files() noexcept {
  TemporaryFiles& all = temporary_files();
  all.mutex.lock();  // and never unlocked
  std::error_code ignored;
  for (const std::filesystem::path& name : all.names) std::filesystem::remove_all(name, ignored);
}

bool is_standard_output(const std::filesystem::path& path) {
  constexpr std::string_view names[] = {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"};
  return std::find(std::begin(names), std::end(names), path.native()) != std::end(names);
}

std::string output_name(const std::filesystem::path& path) {
  return is_standard_output(path) ? "standard output" : path.string();
}

std::filesystem::path follow_links(const std::filesystem::path& path) {
  constexpr int most = 40;  // as the system's own limit
  std::error_code error;
  std::filesystem::path end = path;
  for (int links = 0; std::filesystem::is_symlink(end, error); ++links) {
    if (links == most) refuse(path, ELOOP);
    const std::filesystem::path next = std::filesystem::read_symlink(end, error);
    if (error) refuse(path, error.value(), error.message());
    end = end.parent_path() / next;
  }
  return end;
}

void check_writable(const std::filesystem::path& path) {
  if (is_standard_output(path)) return;
  std::error_code error;
  if (path.empty()) refuse(path, "the path is empty");
  if (std::filesystem::is_directory(path, error) || !path.has_filename()) {
    refuse(path, EISDIR, "it is a directory; name a file in it");
  }
  const bool exists = std::filesystem::exists(path, error);
  if (exists && ::access(path.c_str(), W_OK) != 0) refuse(path, errno);
  if (written_directly(path)) return;
  const std::filesystem::path directory = directory_of(follow_links(path));
  if (!std::filesystem::is_directory(directory, error)) {
    refuse(path, ENOENT, fmt::format("there is no directory {}", directory.string()));
  }
  if (::access(directory.c_str(), W_OK) != 0) refuse(path, errno);
}

}  // namespace hodt
