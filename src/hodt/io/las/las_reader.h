// Points from LAS files, also compressed (LAZ, COPC).
// Tested by tests/io/las_test.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "hodt/geometry/point_set.h"
#include "hodt/io/input_text.h"
#include "hodt/io/las/las_choice.h"

namespace hodt {

/// What a LAS file holds, and which points of it were taken.
struct LasCounts {
  std::uint64_t total = 0;
  std::uint64_t withheld = 0;      ///< marked to be left out
  std::uint64_t other_class = 0;   ///< left out because of their class
  std::uint64_t other_return = 0;  ///< of the classes taken, left out because of their return
  std::uint64_t taken = 0;
  bool all_classes = false;
  LasChoice::Returns returns = LasChoice::Returns::all;
  std::array<std::uint64_t, LasChoice::kClasses> of_class{};  ///< not withheld
  std::array<std::uint64_t, LasChoice::kClasses> taken_of_class{};
};

/// What heights are, by EPSG's numbers; 0 where nothing is said.
struct LasHeights {
  std::uint16_t system = 0;  ///< "NAVD88 height" and the like
  std::uint16_t unit = 0;
};

struct LasPoints {
  /// In the order of the file; each coordinate is the stored integer times the file's scale plus
  /// its offset, both rounded to double. The system is the file's code ("EPSG:25832"), its
  /// well-known text if it has none, or nothing.
  PointSet points;
  /// Beside a code, which is that of x and y alone.
  LasHeights heights;
  LasCounts counts;
};

bool is_las(std::string_view bytes);

/// Reads LAS 1.0 to 1.4 of all point formats, and LAZ. Withheld points are left out. Throws
/// InputError, saying where, if the file is damaged or no point of it is wanted.
LasPoints read_las(const InputText& input, const LasChoice& choice = {});

/// "2 (ground): 123 of 456 points, 3 withheld": which were taken.
std::string text_of(const LasCounts& counts);

}  // namespace hodt
