#include "hodt/io/png.h"

#include <cstdint>
#include <new>
#include <string_view>

#include <zlib.h>

#include "hodt/io/bytes.h"

namespace hodt {

namespace {

void append_big(std::string& bytes, std::uint32_t value) {
  char raw[4];
  put_big(raw, value);
  bytes.append(raw, sizeof raw);
}

void append_chunk(std::string& file, std::string_view kind, std::string_view data) {
  append_big(file, static_cast<std::uint32_t>(data.size()));
  const std::size_t begin = file.size();
  file.append(kind).append(data);
  const auto* checked = reinterpret_cast<const Bytef*>(file.data() + begin);
  append_big(file, static_cast<std::uint32_t>(crc32_z(0, checked, file.size() - begin)));
}

std::string packed(std::string_view bytes) {
  std::string result(compressBound(bytes.size()), '\0');
  uLongf size = result.size();
  if (compress2(reinterpret_cast<Bytef*>(result.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), 9) != Z_OK)
    throw std::bad_alloc();
  result.resize(size);
  return result;
}

}  // namespace

std::string png_of(const Image& image) {
  std::string header;
  append_big(header, static_cast<std::uint32_t>(image.width));
  append_big(header, static_cast<std::uint32_t>(image.height));
  header.append("\x08\x03\0\0\0", 5);  // numbers of colours in 8 bits
  std::string colours;
  for (const Colour& c : image.colours)
    colours += {static_cast<char>(c.red), static_cast<char>(c.green), static_cast<char>(c.blue)};
  std::string rows;
  rows.reserve((image.width + 1) * image.height);
  for (std::size_t row = 0; row < image.height; ++row) {
    rows += '\0';  // as they are
    rows.append(reinterpret_cast<const char*>(image.pixels.data()) + row * image.width,
                image.width);
  }
  std::string file = "\x89PNG\r\n\x1a\n";
  append_chunk(file, "IHDR", header);
  append_chunk(file, "PLTE", colours);
  append_chunk(file, "IDAT", packed(rows));
  append_chunk(file, "IEND", {});
  return file;
}

}  // namespace hodt
