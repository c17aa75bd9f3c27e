// Which columns the user says are the coordinates.
// Tested by tests/io/point_dialects_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace hodt {

inline constexpr std::array<const char*, 3> kAxisNames = {"x", "y", "z"};

/// For x, y and z a column's name or its number, from 1; empty where the table itself has to say.
struct ColumnChoice {
  std::array<std::string, 3> axes;

  bool empty() const { return axes[0].empty() && axes[1].empty() && axes[2].empty(); }
};

/// What messages advise where columns must be named.
inline constexpr const char* kSayColumns =
    "say which columns are x, y and z by name or number, as in --columns x=2,y=3,z=4";

/// Reads "x=2,y=3,z=height"; what is left out stays empty. A name may contain commas. Throws
/// ParameterError, naming the option.
ColumnChoice parse_column_choice(std::string_view option, std::string_view text);

}  // namespace hodt
