#include "app/common_system.h"

#include "app/points_input.h"
#include <fmt/format.h>

#include "hodt/io/crs.h"

namespace hodt::app {

namespace {

HeightUnit unit_of(const std::string& crs) {
  const CrsUnits units = crs_units(crs);
  return {units.metres, units.vertical};
}

}  // namespace

void CommonSystem::add(const std::string& file, const std::string& crs, const HeightUnit& unit) {
  require_same_crs(file_, crs_, file, crs);
  add_unit(file, unit.metres == 0 ? unit_of(crs) : unit);
  const bool tells_more = crs_.empty() || (tells_heights(crs) && !tells_heights(crs_));
  if (crs.empty() || !tells_more) return;
  file_ = file;
  crs_ = crs;
}

void CommonSystem::replace(const std::string& name, const std::string& crs) {
  file_ = name;
  crs_ = crs;
  const HeightUnit unit = unit_of(crs);
  if (unit.metres == 0) return;
  file_of_unit_ = name;
  unit_ = unit;
}

void CommonSystem::add_unit(const std::string& file, const HeightUnit& unit) {
  if (unit.metres == 0) return;
  if (unit_.metres == 0) {
    file_of_unit_ = file;
    unit_ = unit;
  } else if (!is_same_unit(unit.metres, unit_.metres)) {
    throw InputError(fmt::format(
        "{} has heights in {}, and {} in {}; bring them to one unit first, with gdal_calc or "
        "ogr2ogr -t_srs for example",
        display_name(file_of_unit_), unit_.name, display_name(file), unit.name));
  }
}

}  // namespace hodt::app
