#include "hodt/io/las_table.h"

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/las/las_reader.h"
#include "hodt/io/point_doubts.h"

namespace hodt {

PointTable read_las_table(const InputText& input, const PointChoice& choice) {
  LasPoints las = read_las(input, choice.las.value_or(LasChoice()));
  std::vector<std::string> warnings = warn_of_no_data(las.points);
  const TakenColumns taken{{1, "X"}, {2, "Y"}, {{3, "Z"}}, las.counts};
  return {std::move(las.points), taken, std::move(warnings)};
}

}  // namespace hodt
