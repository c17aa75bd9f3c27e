#include "app/manual/choices.h"

#include <cstddef>

#include "hodt/delaunay/duplicates.h"
#include "hodt/optimize/objective.h"
#include "hodt/terrain/terrain.h"

namespace hodt::manual {

namespace {

using Words = std::vector<std::string>;

/// The words of "area, angle".
Words split(const std::string& list) {
  Words words;
  for (std::size_t begin = 0; begin < list.size();) {
    const std::size_t end = std::min(list.find(", ", begin), list.size());
    words.push_back(list.substr(begin, end - begin));
    begin = end + 2;
  }
  return words;
}

Words objectives() {
  Words words;
  for (const Objective::Kind kind :
       {Objective::min_local_minima, Objective::min_local_maxima, Objective::min_local_extrema,
        Objective::min_max_degree, Objective::none})
    words.push_back(name_of(Objective(kind)));
  for (const std::string direction : {"min", "max"})
    for (const std::string aggregate : {"sum", "max", "min"})
      for (const std::string& measure : split(measure_names()))
        words.push_back(direction + "-" + aggregate + "-" + measure);
  return words;
}

Words duplicate_rules() {
  Words words;
  for (const DuplicateRule rule : {DuplicateRule::lowest, DuplicateRule::highest,
                                   DuplicateRule::mean, DuplicateRule::first, DuplicateRule::error})
    words.push_back(name_of(rule));
  return words;
}

Words terrains() {
  Words words;
  for (const TerrainInfo& terrain : built_in_terrains()) words.emplace_back(terrain.name);
  return words;
}

}  // namespace

Words choices_of(std::string_view command, std::string_view option) {
  if (option == "--objective") {
    Words words = objectives();
    words.emplace_back("terrain");
    if (command == "compare") words.emplace_back("all");
    return words;
  }
  if (option == "--method") return {"auto", "greedy", "flip", "exact"};
  if (option == "--duplicates") return duplicate_rules();
  if (option == "--las-return") return {"first", "last", "all"};
  if (option == "--class" && command == "edges") return {"useful", "kod", "fixed", "delaunay"};
  if (option == "--class" && command == "triangles") return {"valid", "kod"};
  if (option == "NAME" && command == "sample") return terrains();
  return {};
}

bool takes_several(std::string_view option) {
  return option == "--objective";
}

}  // namespace hodt::manual
