// The coordinate reference system, and the unit of heights, that all inputs of a run have in
// common: as much as any of them says.
// Tested by tests/app/inputs_test.cpp.
#pragma once

#include <string>

#include "hodt/io/point_table.h"

namespace hodt::app {

class CommonSystem {
 public:
  /// Adds what a file says, which may be nothing; `unit` counts more than the system's own. Throws
  /// InputError, naming both, if another file says something else.
  void add(const std::string& file, const std::string& crs, const HeightUnit& unit = {});

  /// Somebody knows the system better than the files that were added.
  void replace(const std::string& name, const std::string& crs);

 private:
  void add_unit(const std::string& file, const HeightUnit& unit);

  std::string file_, crs_;  ///< the one that tells most, and who says so
  std::string file_of_unit_;
  HeightUnit unit_;
};

}  // namespace hodt::app
