// Every subcommand that reads points, with an input in place of %.
#pragma once

#include <string>

namespace hodt::test {

inline const char* const kPointCommands[] = {"info %",
                                             "triangulate % -o out.obj -k 1",
                                             "edges % -k 1 -o out.csv",
                                             "triangles % -k 1 -o out.csv",
                                             "voronoi % -m 1 -o out.geojson",
                                             "compare % --orders 1"};

inline std::string with(const std::string& command, const std::string& input) {
  const std::size_t at = command.find('%');
  return command.substr(0, at) + input + command.substr(at + 1);
}

}  // namespace hodt::test
