#include "hodt/io/column_choice.h"

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/field_kind.h"

namespace hodt {

namespace {

constexpr std::size_t kNoAxis = kAxisNames.size();

/// The axis of "x=..." at the front of the text.
std::size_t axis_of(std::string_view text) {
  if (text.size() < 2 || text[1] != '=') return kNoAxis;
  for (std::size_t axis = 0; axis < kAxisNames.size(); ++axis)
    if (lower_case(text.substr(0, 1)) == kAxisNames[axis]) return axis;
  return kNoAxis;
}

/// Where the next "x=..." begins: behind a comma.
std::size_t end_of_item(std::string_view text) {
  std::size_t comma = text.find(',');
  while (comma != text.npos && axis_of(text.substr(comma + 1)) == kNoAxis)
    comma = text.find(',', comma + 1);
  return comma;
}

}  // namespace

ColumnChoice parse_column_choice(std::string_view option, std::string_view text) {
  ColumnChoice choice;
  std::string_view rest = text;
  for (bool more = !text.empty(); more;) {
    const std::size_t axis = axis_of(rest);
    const std::size_t end = end_of_item(rest);
    const std::string_view column =
        axis == kNoAxis ? std::string_view() : trimmed(rest.substr(2, end - 2));
    if (column.empty() || !choice.axes[axis].empty()) {
      throw ParameterError(fmt::format(
          "{} must name columns or number them from 1, each axis once, like x=2,y=3,z=height, not "
          "'{}'",
          option, text));
    }
    choice.axes[axis] = column;
    more = end != rest.npos;
    if (more) rest.remove_prefix(end + 1);
  }
  return choice;
}

}  // namespace hodt
