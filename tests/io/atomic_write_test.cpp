#include "hodt/io/atomic_write.h"

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "temporary_directory.h"
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "hodt/io/system_file_error.h"

namespace hodt {
namespace {

using test::content_of;
using test::message_of;
using test::TemporaryDirectory;

mode_t mode_of(const std::filesystem::path& path) {
  struct stat status;
  EXPECT_EQ(::stat(path.c_str(), &status), 0);
  return status.st_mode & 07777;
}

TEST(AtomicWrite, MakesAnOrdinaryFile) {
  const TemporaryDirectory directory;
  const mode_t old = ::umask(027);
  atomic_write(directory / "new", "content");
  ::umask(old);
  EXPECT_EQ(content_of(directory / "new"), "content");
  EXPECT_EQ(mode_of(directory / "new"), mode_t{0640});
  EXPECT_EQ(directory.entries(), 1u);
}

TEST(AtomicWrite, ReplacesAndKeepsPermissions) {
  const TemporaryDirectory directory;
  const auto path = directory.file("old", "before");
  ::chmod(path.c_str(), 0600);
  atomic_write(path, "after");
  EXPECT_EQ(content_of(path), "after");
  EXPECT_EQ(mode_of(path), mode_t{0600});
}

TEST(AtomicWrite, WritesThroughLinks) {
  const TemporaryDirectory directory;
  const auto target = directory.file("target", "before");
  std::filesystem::create_symlink("target", directory / "link");
  std::filesystem::create_symlink("nothing-yet", directory / "dangling");
  atomic_write(directory / "link", "after");
  atomic_write(directory / "dangling", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(directory / "link"));
  EXPECT_EQ(content_of(target), "after");
  EXPECT_TRUE(std::filesystem::is_symlink(directory / "dangling"));
  EXPECT_EQ(content_of(directory / "nothing-yet"), "new");
}

TEST(AtomicWrite, RefusesLinksWithoutAnEnd) {
  const TemporaryDirectory directory;
  std::filesystem::create_symlink("there", directory / "here");
  std::filesystem::create_symlink("here", directory / "there");
  const auto here = directory / "here";
  EXPECT_THROW(check_writable(here), FileError);
  const std::string message = message_of<FileError>([&] { atomic_write(here, "content"); });
  EXPECT_NE(message.find("Too many levels of symbolic links"), std::string::npos) << message;
  EXPECT_TRUE(std::filesystem::is_symlink(here));
  EXPECT_EQ(directory.entries(), 2u);
}

TEST(AtomicWrite, TellsTheNumberOfTheSystemAndTheFile) {
  const TemporaryDirectory directory;
  const auto number_of = [](const std::filesystem::path& path, const auto& write) {
    try {
      write(path);
    } catch (const SystemFileError& error) {
      EXPECT_EQ(error.file(), path);
      return error.number();
    }
    return 0;
  };
  const auto missing = directory / "no" / "file";
  std::filesystem::create_symlink("loop", directory / "loop");
  const auto check = [](const auto& path) { check_writable(path); };
  const auto write = [](const auto& path) { atomic_write(path, "content"); };
  EXPECT_EQ(number_of(missing, check), ENOENT);
  EXPECT_EQ(number_of(missing, write), ENOENT);
  EXPECT_EQ(number_of(std::filesystem::path(directory / "loop"), check), ELOOP);
  EXPECT_EQ(number_of(std::filesystem::path(directory / "x").parent_path(), check), EISDIR);
  EXPECT_EQ(number_of("/dev/full", write), ENOSPC);
}

TEST(AtomicWrite, CompanionsAppearWithTheFile) {
  const TemporaryDirectory directory;
  const auto old = directory.file("old.shp", "before");
  for (const char* name : {"old.dbf", "old.qix", "other.qix"}) directory.file(name, "before");
  const auto make = [&](const std::filesystem::path& path) {
    EXPECT_EQ(path.filename(), "old.shp");
    for (const char* extension : {".shp", ".shx", ".dbf", ".tmp"})
      std::ofstream(std::filesystem::path(path).replace_extension(extension)) << extension;
  };
  const std::string companions = ".dbf .shx .qix";
  {
    OutputFile file(old);
    file.fill_by_name(make, companions);
    file.finish();
    EXPECT_EQ(content_of(old), "before");
    EXPECT_EQ(content_of(directory / "old.dbf"), "before");
    EXPECT_EQ(content_of(directory / "old.qix"), "before");
    EXPECT_FALSE(std::filesystem::exists(directory / "old.shx"));
  }
  EXPECT_EQ(directory.entries(), 4u) << "not committed";
  atomic_write(old, [&](OutputFile& file) { file.fill_by_name(make, companions); });
  for (const char* extension : {".shp", ".dbf", ".shx"})
    EXPECT_EQ(content_of(directory / ("old" + std::string(extension))), extension);
  EXPECT_FALSE(std::filesystem::exists(directory / "old.qix")) << "of the old file";
  EXPECT_EQ(content_of(directory / "other.qix"), "before");
  EXPECT_EQ(directory.entries(), 4u);
}

TEST(AtomicWrite, WhatTellsOfAnOldFileGoesWithIt) {
  const TemporaryDirectory directory;
  const auto old = directory.file("old.tif", "before");
  for (const char* name : {"old.tif.ovr", "old.tif-wal", "old.tif.txt", "old.ovr"})
    directory.file(name, "before");
  std::filesystem::create_symlink("old.tif", directory / "link.tif");
  directory.file("link.tif.ovr", "before");
  {
    OutputFile file(old);
    file.write("after");
    file.outdate(".ovr -wal -shm");
  }
  EXPECT_EQ(directory.entries(), 7u) << "not committed";
  atomic_write(directory / "link.tif", [&](OutputFile& file) {
    file.write("after");
    file.outdate(".ovr -wal -shm");
  });
  EXPECT_EQ(content_of(old), "after");
  EXPECT_FALSE(std::filesystem::exists(directory / "old.tif.ovr"));
  EXPECT_FALSE(std::filesystem::exists(directory / "old.tif-wal"));
  for (const char* name : {"old.tif.txt", "old.ovr", "link.tif.ovr"})
    EXPECT_EQ(content_of(directory / name), "before") << name;
  EXPECT_EQ(directory.entries(), 5u);
}

TEST(AtomicWrite, CommitsAllOrNone) {
  const TemporaryDirectory directory;
  const auto open = [&](std::initializer_list<std::string_view> names) {
    std::vector<std::unique_ptr<OutputFile>> files;
    for (const std::string_view name : names) {
      files.push_back(std::make_unique<OutputFile>(
          name.starts_with('/') ? std::filesystem::path(name) : directory / name));
      files.back()->write(name);
    }
    return files;
  };
  {
    const auto files = open({"a", "b"});
    files[0]->finish();
    EXPECT_FALSE(std::filesystem::exists(directory / "a"));
    commit_together(files);
  }
  EXPECT_EQ(content_of(directory / "a"), "a");
  EXPECT_EQ(content_of(directory / "b"), "b");
  EXPECT_EQ(directory.entries(), 2u);
  EXPECT_THROW(open({"c", "/dev/full"}), FileError);
  EXPECT_EQ(directory.entries(), 2u);
}

TEST(AtomicWrite, KnowsStandardOutput) {
  for (const char* name : {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"})
    EXPECT_TRUE(is_standard_output(name)) << name;
  for (const char* name : {"", "./-", "/dev/stderr", "stdout"})
    EXPECT_FALSE(is_standard_output(name)) << name;
}

TEST(AtomicWrite, LeavesTheOldFileIfTheWriterThrows) {
  const TemporaryDirectory directory;
  const auto path = directory.file("old", "before");
  const auto fill = [](OutputFile& file) {
    file.write("half");
    throw InputError("stop");
  };
  EXPECT_THROW(atomic_write(path, fill), InputError);
  EXPECT_EQ(content_of(path), "before");
  EXPECT_EQ(directory.entries(), 1u);
}

/// Files may not grow beyond `bytes`: as good as a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_;
  void (*handler_)(int);
};

TEST(AtomicWrite, LeavesTheOldFileIfTheDiskIsFull) {
  const TemporaryDirectory directory;
  const auto path = directory.file("old", "before");
  const std::string large(100000, 'x');
  std::string message;
  {
    const FileSizeLimit limit(50000);
    message = message_of<FileError>([&] { atomic_write(path, large); });
    EXPECT_THROW(atomic_write(directory / "new", large), FileError);
  }
  EXPECT_NE(message.find(path.string()), std::string::npos) << message;
  EXPECT_EQ(content_of(path), "before");
  EXPECT_EQ(directory.entries(), 1u);
}

// ---- Files that a library makes by itself ----

using Make = std::function<void(const std::filesystem::path&)>;

void write_by_name(const std::filesystem::path& path, const Make& make) {
  atomic_write(path, [&](OutputFile& file) { file.fill_by_name(make); });
}

/// As a library would: with the plain means of the language, and something beside it.
void make_large(const std::filesystem::path& path) {
  EXPECT_FALSE(std::filesystem::exists(path));
  std::ofstream(path.parent_path() / "journal") << "beside";
  std::ofstream stream(path);
  stream << std::string(3000000, 'x') << "end" << std::flush;
  if (!stream) throw FileError("the library has failed");
}

TEST(FillByName, MakesAnOrdinaryFile) {
  const TemporaryDirectory directory;
  std::filesystem::path name;
  const mode_t old = ::umask(027);
  write_by_name(directory / "new .gpkg",
                [&](const std::filesystem::path& path) { make_large(name = path); });
  ::umask(old);
  EXPECT_EQ(name.filename(), "new .gpkg");
  EXPECT_EQ(content_of(directory / "new .gpkg"), std::string(3000000, 'x') + "end");
  EXPECT_EQ(mode_of(directory / "new .gpkg"), mode_t{0640});
  EXPECT_EQ(directory.entries(), 1u);
}

TEST(FillByName, ReplacesAndKeepsPermissions) {
  const TemporaryDirectory directory;
  const auto path = directory.file("old", "before");
  ::chmod(path.c_str(), 0600);
  std::filesystem::create_symlink("old", directory / "link");
  write_by_name(directory / "link", make_large);
  EXPECT_EQ(content_of(path).size(), 3000003u);
  EXPECT_EQ(mode_of(path), mode_t{0600});
  EXPECT_TRUE(std::filesystem::is_symlink(directory / "link"));
  EXPECT_EQ(directory.entries(), 2u);
}

TEST(FillByName, StreamsToDevicesAndPipes) {
  const std::string message = message_of<FileError>([] { write_by_name("/dev/full", make_large); });
  EXPECT_NE(message.find("No space"), std::string::npos) << message;
  write_by_name("/dev/null", make_large);
  const TemporaryDirectory directory;
  ASSERT_EQ(::mkfifo((directory / "pipe").c_str(), 0600), 0);
  std::string read;
  std::thread reader([&] { read = content_of(directory / "pipe"); });
  write_by_name(directory / "pipe", make_large);
  reader.join();
  EXPECT_EQ(read, std::string(3000000, 'x') + "end");
  EXPECT_EQ(directory.entries(), 1u);
}

TEST(FillByName, LeavesTheOldFileIfTheLibraryFails) {
  const TemporaryDirectory directory;
  const auto path = directory.file("old", "before");
  {
    const FileSizeLimit limit(50000);
    EXPECT_THROW(write_by_name(path, make_large), FileError);
    EXPECT_THROW(write_by_name(directory / "new", make_large), FileError);
  }
  EXPECT_THROW(write_by_name(path, [](const auto&) {}), FileError) << "made nothing";
  EXPECT_EQ(content_of(path), "before");
  EXPECT_EQ(directory.entries(), 1u);
}

TEST(FillByName, FoldersGoWithTheProcess) {
  const TemporaryDirectory directory;
  const pid_t process = ::fork();
  if (process == 0) {
    write_by_name(directory / "new", [](const std::filesystem::path& path) {
      make_large(path);
      abandon_output_files();
      ::_exit(0);
    });
  }
  ASSERT_EQ(::waitpid(process, nullptr, 0), process);
  EXPECT_EQ(directory.entries(), 0u);
}

TEST(AtomicWrite, WritesDevicesDirectly) {
  EXPECT_NO_THROW(atomic_write("/dev/null", "nothing"));
  const std::string message = message_of<FileError>([] { atomic_write("/dev/full", "much"); });
  EXPECT_NE(message.find("No space"), std::string::npos) << message;
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(AtomicWrite, RefusesBeforehandWhatCannotWork) {
  const TemporaryDirectory directory;
  EXPECT_THROW(check_writable(directory.path()), FileError);
  EXPECT_THROW(check_writable(directory / "none" / "file"), FileError);
  EXPECT_THROW(check_writable(""), FileError);
  EXPECT_NO_THROW(check_writable(directory / "file"));
  EXPECT_NO_THROW(check_writable("-"));
  EXPECT_NO_THROW(check_writable("file-in-this-directory"));
  EXPECT_EQ(directory.entries(), 0u);
}

}  // namespace
}  // namespace hodt
