#include "hodt/io/las/las_choice.h"

#include <charconv>
#include <cstdint>

#include <fmt/format.h>

#include "hodt/base/error.h"

namespace hodt {

namespace {

std::uint8_t parse_class(std::string_view word) {
  std::uint8_t number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size())
    throw ParameterError(
        fmt::format("--las-class takes numbers of classes from 0 to 255 with commas between, like "
                    "2 or 2,9, or all; '{}' is none",
                    word));
  return number;
}

}  // namespace

LasChoice parse_las_choice(std::string_view classes, std::string_view returns) {
  LasChoice choice;
  if (classes == "all") {
    choice.classes = LasChoice::Classes::all;
  } else if (!classes.empty()) {
    choice.classes = LasChoice::Classes::listed;
    for (std::size_t begin = 0; begin <= classes.size();) {
      const std::size_t end = std::min(classes.find(',', begin), classes.size());
      choice.listed.set(parse_class(classes.substr(begin, end - begin)));
      begin = end + 1;
    }
  }
  if (returns == "first") {
    choice.returns = LasChoice::Returns::first;
  } else if (returns == "last") {
    choice.returns = LasChoice::Returns::last;
  } else if (!returns.empty() && returns != "all") {
    throw ParameterError(
        fmt::format("--las-return takes first, last or all, and '{}' is none of them", returns));
  }
  return choice;
}

std::string las_class_name(std::size_t number) {
  constexpr std::string_view names[] = {
      "never classified",  "unclassified",    "ground",         "low vegetation",
      "medium vegetation", "high vegetation", "building",       "low point",
      "model key point",   "water",           "rail",           "road surface",
      "overlap",           "wire guard",      "wire conductor", "transmission tower",
      "wire connector",    "bridge deck",     "high noise"};
  if (number >= std::size(names)) return fmt::format("{}", number);
  return fmt::format("{} ({})", number, names[number]);
}

}  // namespace hodt
