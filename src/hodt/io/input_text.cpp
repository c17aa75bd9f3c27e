#include "hodt/io/input_text.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/gzip.h"
#include "hodt/io/system_file_error.h"
#include "hodt/io/text_encoding.h"

namespace hodt {

namespace {

struct CloseFile {
  void operator()(std::FILE* file) const {
    if (file != stdin) std::fclose(file);
  }
};
using FileHandle = std::unique_ptr<std::FILE, CloseFile>;

[[noreturn]] void throw_unreadable(const std::filesystem::path& path, int error,
                                   const std::string& why) {
  throw SystemFileError(fmt::format("cannot read {}: {}", display_name(path), why), error, path);
}
[[noreturn]] void throw_unreadable(const std::filesystem::path& path, int error) {
  throw_unreadable(path, error, std::strerror(error));
}

FileHandle open_input(const std::filesystem::path& path) {
  if (path == kStandardInput) return FileHandle(stdin);
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw_unreadable(path, EISDIR, "it is a directory; name a file in it");
  }
  FileHandle file(std::fopen(path.c_str(), "rb"));
  if (!file) throw_unreadable(path, errno);
  // Reads go straight into our buffer.
  std::setvbuf(file.get(), nullptr, _IONBF, 0);
  return file;
}

/// A guess to start with; pipes do not know.
std::size_t expected_size(const std::filesystem::path& path) {
  constexpr std::size_t fallback = std::size_t{1} << 20;
  if (path == kStandardInput) return fallback;
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  return error || size == 0 ? fallback : static_cast<std::size_t>(size);
}

Buffer<char> grown(const Buffer<char>& bytes, std::size_t used) {
  Buffer<char> larger(2 * bytes.size());
  std::memcpy(larger.data(), bytes.data(), used);
  return larger;
}

void add_padding(InputText& input) {
  input.bytes[input.size] = '\n';
  std::memset(input.bytes.data() + input.size + 1, 0, InputText::kPadding - 1);
}

}  // namespace

InputText read_input(const std::filesystem::path& path) {
  InputText input;
  input.name = display_name(path);
  const FileHandle file = open_input(path);
  // One byte more than expected, so that the end of the file shows without growing.
  input.bytes = Buffer<char>(expected_size(path) + InputText::kPadding + 1);
  for (;;) {
    const std::size_t room = input.bytes.size() - InputText::kPadding - input.size;
    const std::size_t got = std::fread(input.bytes.data() + input.size, 1, room, file.get());
    input.size += got;
    if (got == room) {
      input.bytes = grown(input.bytes, input.size);
    } else if (std::ferror(file.get())) {
      throw_unreadable(path, errno);
    } else {
      break;
    }
  }
  if (is_gzip(input.view())) input = gunzip(input);
  decode(input);
  add_padding(input);
  return input;
}

void require_readable(const std::filesystem::path& path) {
  open_input(path);
}

void require_text(const InputText& input) {
  const std::string_view text = input.view();
  if (text.empty()) throw InputError(fmt::format("{} is empty", input.name));
  constexpr std::size_t block = std::size_t{1} << 16;
  if (text.substr(0, block).find('\0') != std::string_view::npos) {
    throw InputError(fmt::format("{} is a binary file in no format that hodt reads", input.name));
  }
}

std::string display_name(const std::filesystem::path& path) {
  return path == kStandardInput ? "standard input" : path.string();
}

}  // namespace hodt
