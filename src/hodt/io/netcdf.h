// NetCDF in its classic format, of 64-bit offsets, as far as it holds a mesh: dimensions, and
// variables with attributes. Every reader of netCDF knows it; docs/decisions/own-netcdf.md says why
// no library writes it here.
// Tested by tests/io/netcdf_test.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "hodt/io/atomic_write.h"

namespace hodt {

struct NetcdfAttribute {
  std::string name;
  std::variant<std::string, std::int32_t> value;
};

struct NetcdfDimension {
  std::string name;
  std::size_t size = 0;
};

enum class NetcdfType : std::uint32_t { int32 = 4, float64 = 6 };

struct NetcdfVariable {
  std::string name;
  NetcdfType type = NetcdfType::int32;
  /// By their places in the file's list; none for a single value.
  std::vector<std::size_t> dimensions;
  std::vector<NetcdfAttribute> attributes;
  /// Writes the values of a record, which is one of the first dimension, as big-endian bytes at the
  /// place given; returns the end.
  std::function<char*(std::size_t record, char* to)> put;
};

struct NetcdfContent {
  std::vector<NetcdfDimension> dimensions;
  std::vector<NetcdfAttribute> attributes;
  std::vector<NetcdfVariable> variables;
};

/// Throws InputError if something is larger than the format can hold: 4 GiB a variable, and
/// 2^31 - 1 a dimension.
void write_netcdf(const NetcdfContent& content, OutputFile& file);

}  // namespace hodt
