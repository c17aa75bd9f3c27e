#include "hodt/io/tin_file.h"

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/atomic_write.h"
#include "hodt/io/file_name.h"
#include "hodt/io/input_text.h"
#include "hodt/io/obj.h"
#include "hodt/io/ply.h"

namespace hodt {

namespace {

struct Format {
  std::string_view extension;
  Tin (*parse)(const InputText&);
  void (*write)(const Tin&, OutputFile&);
};

constexpr Format kFormats[] = {{".obj", parse_obj, write_obj}, {".ply", parse_ply, write_ply}};

const Format* find_format(std::string_view extension) {
  for (const Format& format : kFormats) {
    if (format.extension == extension) return &format;
  }
  return nullptr;
}

std::string known_extensions() {
  std::string known;
  for (const Format& format : kFormats) {
    known += known.empty() ? "" : ", ";
    known += format.extension;
  }
  return known;
}

[[noreturn]] void throw_unknown(std::string_view verb, const std::filesystem::path& path,
                                const std::string& extension) {
  throw ParameterError(fmt::format(
      "cannot {} a mesh {}: {}; known are {}", verb, path.string(),
      extension.empty() ? "the name has no extension" : "unknown extension '" + extension + "'",
      known_extensions()));
}

const Format& format_to_write(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);  // meshes are not packed
  const Format* format = find_format(extension);
  if (!format) throw_unknown("write", path, extension);
  return *format;
}

}  // namespace

Tin read_tin(const std::filesystem::path& path) {
  const std::string extension = format_extension(path);
  const Format* format = find_format(extension);
  if (!format && !extension.empty()) throw_unknown("read", path, extension);
  const InputText input = read_input(path);
  if (!format) format = find_format(is_ply(input) ? ".ply" : ".obj");
  return format->parse(input);
}

void write_tin(const Tin& tin, const std::filesystem::path& path) {
  const Format& format = format_to_write(path);
  atomic_write(path, [&](OutputFile& file) { format.write(tin, file); });
}

void write_tin(const Tin& tin, OutputFile& file) {
  format_to_write(file.path()).write(tin, file);
}

void check_output_extension(const std::filesystem::path& path) {
  format_to_write(path);
}

}  // namespace hodt
