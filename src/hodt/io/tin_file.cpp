#include "hodt/io/tin_file.h"

#include "hodt/io/atomic_write.h"
#include "hodt/io/file_name.h"
#include "hodt/io/formats.h"
#include "hodt/io/input_text.h"
#include "hodt/io/obj.h"
#include "hodt/io/ply.h"

namespace hodt {

Tin read_tin(const std::filesystem::path& path) {
  if (!format_extension(path).empty()) return format_for(path, Use::read_tin).read_tin(path);
  const InputText input = read_input(path);
  return is_ply(input) ? parse_ply(input) : parse_obj(input);
}

void write_tin(const Tin& tin, const std::filesystem::path& path) {
  const Format& format = format_for(path, Use::write_tin);
  atomic_write(path, [&](OutputFile& file) { format.write_tin(tin, file); });
}

void write_tin(const Tin& tin, OutputFile& file) {
  format_for(file.path(), Use::write_tin).write_tin(tin, file);
}

void check_output_extension(const std::filesystem::path& path) {
  format_for(path, Use::write_tin);
}

}  // namespace hodt
