#include "hodt/io/gzip.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>

#include <fmt/format.h>
#include <zlib.h>

#include "hodt/base/error.h"

namespace hodt {

namespace {

constexpr std::string_view kMagic = "\x1f\x8b";
/// zlib's window bits for the gzip wrapper with the largest window.
constexpr int kGzipWindow = 15 + 16;
/// Of unpacked to packed bytes, seldom exceeded by tables and meshes.
constexpr std::size_t kUsualRatio = 32;

/// zlib counts in 32 bits, so larger arrays go in pieces.
uInt piece(std::size_t size) {
  return static_cast<uInt>(std::min<std::size_t>(size, std::size_t{1} << 30));
}

Bytef* bytes_of(const char* text) {
  return reinterpret_cast<Bytef*>(const_cast<char*>(text));
}

/// The length that the last member claims, as far as that is usual: room for more comes with it.
std::size_t expected_size(std::string_view packed) {
  std::uint32_t claimed = 0;
  if (packed.size() >= 18) {
    for (int i = 0; i < 4; ++i) {
      const auto byte = static_cast<unsigned char>(packed[packed.size() - 4 + i]);
      claimed |= static_cast<std::uint32_t>(byte) << (8 * i);
    }
  }
  return std::clamp<std::size_t>(claimed, packed.size(), kUsualRatio * packed.size());
}

/// zlib's stream, ended whatever happens.
struct Inflater {
  z_stream stream{};
  Inflater() {
    if (inflateInit2(&stream, kGzipWindow) != Z_OK) throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&stream); }
};

struct Deflater {
  z_stream stream{};
  Deflater() {
    if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kGzipWindow, 8,
                     Z_DEFAULT_STRATEGY) != Z_OK) {
      throw std::bad_alloc();
    }
  }
  ~Deflater() { deflateEnd(&stream); }
};

void make_room(InputText& output) {
  if (output.size + InputText::kPadding < output.bytes.size()) return;
  Buffer<char> larger(2 * output.bytes.size());
  std::memcpy(larger.data(), output.bytes.data(), output.size);
  output.bytes = std::move(larger);
}

/// Unpacks the member at the front of `rest` and takes it off.
void unpack_member(std::string_view& rest, InputText& output) {
  Inflater inflater;
  z_stream& stream = inflater.stream;
  int status = Z_OK;
  while (status != Z_STREAM_END) {
    make_room(output);
    const uInt in = piece(rest.size());
    const uInt out = piece(output.bytes.size() - InputText::kPadding - output.size);
    stream.next_in = bytes_of(rest.data());
    stream.avail_in = in;
    stream.next_out = bytes_of(output.bytes.data() + output.size);
    stream.avail_out = out;
    status = inflate(&stream, Z_NO_FLUSH);
    rest.remove_prefix(in - stream.avail_in);
    output.size += out - stream.avail_out;
    if (status == Z_MEM_ERROR) throw std::bad_alloc();
    if (status == Z_BUF_ERROR && rest.empty()) {
      throw InputError(
          fmt::format("{}: the gzip data end too early; the file is cut short", output.name));
    }
    if (status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR) {
      throw InputError(fmt::format("{}: the gzip data are damaged ({})", output.name,
                                   stream.msg ? stream.msg : "unexpected data"));
    }
  }
}

}  // namespace

bool is_gzip(std::string_view bytes) {
  return bytes.starts_with(kMagic);
}

InputText gunzip(const InputText& packed) {
  std::string_view rest = packed.view();
  InputText output;
  output.name = packed.name;
  output.bytes = Buffer<char>(expected_size(rest) + InputText::kPadding + 1);
  while (is_gzip(rest)) unpack_member(rest, output);
  // Tape blocks are filled up with zeros; anything else is not ours to ignore.
  if (rest.find_first_not_of('\0') != std::string_view::npos) {
    throw InputError(
        fmt::format("{}: something other than gzip follows the gzip data", output.name));
  }
  return output;
}

Buffer<char> gzip(std::string_view bytes) {
  Deflater deflater;
  z_stream& stream = deflater.stream;
  Buffer<char> packed(deflateBound(&stream, bytes.size()));
  std::size_t used = 0;
  int status = Z_OK;
  while (status != Z_STREAM_END) {
    const uInt in = piece(bytes.size());
    const uInt out = piece(packed.size() - used);
    stream.next_in = bytes_of(bytes.data());
    stream.avail_in = in;
    stream.next_out = bytes_of(packed.data() + used);
    stream.avail_out = out;
    status = deflate(&stream, in == bytes.size() ? Z_FINISH : Z_NO_FLUSH);
    bytes.remove_prefix(in - stream.avail_in);
    used += out - stream.avail_out;
    if (status != Z_OK && status != Z_STREAM_END) throw std::bad_alloc();
  }
  packed.shrink(used);
  return packed;
}

}  // namespace hodt
