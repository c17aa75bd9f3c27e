// Which columns of a table are the coordinates, by their names in many languages.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hodt {

/// What a name says about its column. A column of another kind is known to hold no coordinate: a
/// point's number, a description, a colour.
enum class ColumnRole { unknown, other, x, y, east, north, longitude, latitude, height };

/// Units, datums and words like "coordinate" do not matter: "Height [m]", "lat_wgs84", "POINT_X".
ColumnRole role_of(std::string_view name);

struct NamedColumns {
  std::optional<std::size_t> x, y, z;
  /// Why the names do not tell which columns are x and y although they name coordinates.
  std::string plane_problem;
  bool several_planes = false;  ///< the problem is that they name too many
  /// Why they do not tell which one is z.
  std::string height_problem;

  bool plane() const { return x && y; }
};

/// x and y come from columns with exactly these names; else from east and north or the like; else
/// longitude is x and latitude is y. Where two columns could be the same, that is a problem.
NamedColumns find_columns(const std::vector<std::string>& names);

/// Whether the names say nothing but where their columns are: "V1", "V2", "V3" or "a", "b", "c".
bool only_number_columns(const std::vector<std::string>& names);

/// The column with this name, if need be in another case.
std::optional<std::size_t> column_called(const std::string& name,
                                         const std::vector<std::string>& names);

/// The names with quotes and commas between, for a message.
std::string listed(const std::vector<std::string>& names);

/// Whether the field is a unit of measure, like "[m]" or "deg".
bool is_unit(std::string_view field);

}  // namespace hodt
