// Which points of a LAS file are wanted.
// Tested by tests/io/las_test.cpp.
#pragma once

#include <bitset>
#include <string>
#include <string_view>

namespace hodt {

struct LasChoice {
  enum class Classes {
    automatic,  ///< ground if there is any, all otherwise
    all,
    listed
  };
  enum class Returns { all, first, last };
  static constexpr std::size_t kClasses = 256;

  Classes classes = Classes::automatic;
  std::bitset<kClasses> listed;
  Returns returns = Returns::all;
};

/// Reads "2", "2,9" or "all", and "all", "first" or "last"; what is empty is left as it is without.
/// Throws ParameterError, naming the option.
LasChoice parse_las_choice(std::string_view classes, std::string_view returns);

/// "2 (ground)"; classes that the standard does not name are their number alone.
std::string las_class_name(std::size_t number);

}  // namespace hodt
