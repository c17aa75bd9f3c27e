#include "hodt/io/las_table.h"

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/crs.h"
#include "hodt/io/formats.h"
#include "hodt/io/las/las_reader.h"
#include "hodt/io/point_doubts.h"

namespace hodt {

namespace {

/// Units of length, by EPSG's numbers.
struct Unit {
  int number;
  double metres;
  const char* name;
};
constexpr Unit kUnits[] = {
    {9001, 1, "metre"}, {9002, 0.3048, "foot"}, {9003, 1200. / 3937, "US survey foot"}};

const Unit* unit_of(int number) {
  for (const Unit& unit : kUnits)
    if (unit.number == number) return &unit;
  return nullptr;
}

/// Some systems of heights have a number for each unit. GeoTIFF 1.0, whose keys these are, numbered
/// them by itself, and the unit stood beside.
struct SystemOfUnit {
  int said, unit, number;
};
constexpr SystemOfUnit kSystems[] = {
    {5102, 9001, 7968}, {5102, 9003, 5702},                      // NGVD29
    {5103, 9001, 5703}, {5103, 9002, 8228}, {5103, 9003, 6360},  // NAVD88
    {5703, 9001, 5703}, {5703, 9002, 8228}, {5703, 9003, 6360},
};

int system_of(const LasHeights& heights) {
  for (const SystemOfUnit& system : kSystems)
    if (system.said == heights.system && system.unit == heights.unit) return system.number;
  return heights.system;
}

/// Joins the system of heights with that of x and y. What does not become a part of it is not lost
/// in silence.
std::vector<std::string> add_heights(const LasHeights& heights, std::string& crs) {
  const Unit* const unit = unit_of(heights.unit);
  const std::string joined =
      heights.system == 0 || crs.empty() ? "" : crs_with_heights(crs, system_of(heights));
  const double metres = crs_units(joined).metres;
  const bool agrees = unit == nullptr || is_same_unit(unit->metres, metres);
  if (!joined.empty() && agrees) {
    crs = joined;
    return {};
  }
  std::vector<std::string> warnings;
  if (unit != nullptr) warnings = height_warnings(crs, unit->metres, unit->name);
  if (heights.system != 0)
    warnings.push_back(fmt::format(
        "its heights are of the system {} (GeoKey 4096){}, which is not kept{}; name the whole by "
        "--crs, like EPSG:25832+7837",
        heights.system, unit != nullptr ? fmt::format(" in {}", unit->name) : "",
        has_gdal() ? "" : " without GDAL"));
  return warnings;
}

}  // namespace

PointTable read_las_table(const InputText& input, const PointChoice& choice) {
  LasPoints las = read_las(input, choice.las.value_or(LasChoice()));
  std::vector<std::string> warnings = warn_of_no_data(las.points);
  for (std::string& warning : add_heights(las.heights, las.points.crs))
    warnings.push_back(std::move(warning));
  const TakenColumns taken{{1, "X"}, {2, "Y"}, {{3, "Z"}}, las.counts};
  PointTable table{std::move(las.points), taken, std::move(warnings)};
  if (const Unit* const unit = unit_of(las.heights.unit))
    table.height_unit = {unit->metres, unit->name};
  return table;
}

}  // namespace hodt
