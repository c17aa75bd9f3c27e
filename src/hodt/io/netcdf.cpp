#include "hodt/io/netcdf.h"

#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/bytes.h"
#include "hodt/io/parallel_text.h"

namespace hodt {

namespace {

// Tags of the header's lists.
constexpr std::uint32_t kDimensions = 10, kVariables = 11, kAttributes = 12;
/// The type of attributes that are text.
constexpr std::uint32_t kText = 2;
/// Text is padded to a multiple of this.
constexpr std::size_t kUnit = 4;

std::size_t size_of(NetcdfType type) {
  return type == NetcdfType::float64 ? 8 : 4;
}

std::size_t padded(std::size_t size) {
  return (size + kUnit - 1) / kUnit * kUnit;
}

/// The records of a variable, and the bytes of each.
std::pair<std::size_t, std::size_t> shape_of(const NetcdfContent& content,
                                             const NetcdfVariable& variable) {
  std::size_t records = 1, bytes = size_of(variable.type);
  for (std::size_t i = 0; i < variable.dimensions.size(); ++i)
    (i == 0 ? records : bytes) *= content.dimensions[variable.dimensions[i]].size;
  return {records, bytes};
}

std::size_t bytes_of(const NetcdfContent& content, const NetcdfVariable& variable) {
  const auto [records, bytes] = shape_of(content, variable);
  return records * bytes;
}

void check_sizes(const NetcdfContent& content) {
  constexpr std::size_t longest = std::numeric_limits<std::int32_t>::max();
  constexpr std::size_t largest = std::numeric_limits<std::uint32_t>::max() - 3;
  bool fits = true;
  for (const NetcdfDimension& dimension : content.dimensions)
    fits = fits && dimension.size <= longest;
  for (const NetcdfVariable& variable : content.variables)
    fits = fits && bytes_of(content, variable) <= largest;
  if (!fits)
    throw InputError(
        "netCDF holds 4 GiB a variable at most, and the mesh takes more; write .ply or .vtu");
}

class Header {
 public:
  void add(std::uint32_t number) { append(number); }
  void add(NetcdfType type) { append(static_cast<std::uint32_t>(type)); }
  void add_size(std::size_t size) { append(static_cast<std::uint32_t>(size)); }
  void add_offset(std::size_t offset) { append(std::uint64_t{offset}); }
  void add_text(std::string_view text) {
    add_size(text.size());
    text_ += text;
    text_.resize(padded(text_.size()), '\0');
  }
  /// The beginning of a list.
  void add_list(std::uint32_t tag, std::size_t size) {
    add(size == 0 ? 0 : tag);
    add_size(size);
  }
  void add(const std::vector<NetcdfAttribute>& attributes) {
    add_list(kAttributes, attributes.size());
    for (const NetcdfAttribute& attribute : attributes) {
      add_text(attribute.name);
      if (const auto* text = std::get_if<std::string>(&attribute.value)) {
        add(kText);
        add_text(*text);
      } else {
        add(NetcdfType::int32);
        add_size(1);
        append(std::get<std::int32_t>(attribute.value));
      }
    }
  }
  const std::string& text() const { return text_; }

 private:
  template <class T>
  void append(T number) {
    char bytes[sizeof number];
    text_.append(bytes, put_big(bytes, number));
  }

  std::string text_ = std::string("CDF\2", 4);
};

/// With the variables one after the other from `begin` on.
std::string header_of(const NetcdfContent& content, std::size_t begin) {
  Header header;
  header.add_size(0);  // records of an unlimited dimension
  header.add_list(kDimensions, content.dimensions.size());
  for (const NetcdfDimension& dimension : content.dimensions) {
    header.add_text(dimension.name);
    header.add_size(dimension.size);
  }
  header.add(content.attributes);
  header.add_list(kVariables, content.variables.size());
  for (const NetcdfVariable& variable : content.variables) {
    header.add_text(variable.name);
    header.add_size(variable.dimensions.size());
    for (const std::size_t dimension : variable.dimensions) header.add_size(dimension);
    header.add(variable.attributes);
    header.add(variable.type);
    const std::size_t size = bytes_of(content, variable);
    header.add_size(size);
    header.add_offset(begin);
    begin += size;
  }
  return header.text();
}

}  // namespace

void write_netcdf(const NetcdfContent& content, OutputFile& file) {
  check_sizes(content);
  // Offsets are of fixed length, so the header's length does not depend on them.
  file.write(header_of(content, header_of(content, 0).size()));
  for (const NetcdfVariable& variable : content.variables) {
    const auto [records, bytes] = shape_of(content, variable);
    write_records(file, records, bytes, variable.put);
  }
}

}  // namespace hodt
