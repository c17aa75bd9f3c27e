#include "hodt/io/column_names.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace hodt {
namespace {

TEST(ColumnNames, units_datums_and_filling_words_do_not_matter) {
  struct Case {
    ColumnRole role;
    std::vector<const char*> names;
  };
  const Case cases[] = {
      {ColumnRole::x,
       {"x", "X", "POINT_X", "x_coord", "xcoord", "X-Koordinate", "X [m]", "x (m)", "X_LV95",
        "utm_x", "coord. x", "xKoord", "posX", "x_utm_33n", "X Wert"}},
      {ColumnRole::y, {"Y", "pointy", "Y / m", "CoordY"}},
      {ColumnRole::east,
       {"Easting", "EAST", "E", "UTM_E", "mE", "Rechtswert [m]", "Ost", "est", "Este (m)", "leste",
        "oost", "\xC3\x96st", "\xD6st", "\xC3\x98st", "E LV95"}},
      {ColumnRole::north, {"northing", "N", "Hochwert", "nord", "norte", "noord", "utm-n"}},
      {ColumnRole::longitude,
       {"lon", "Long", "lng", "Longitude (deg)", "decimalLongitude", "gps_lon", "L\xC3\xA4nge",
        "longitud", "Longitudine", "lon\xC2\xB0"}},
      {ColumnRole::latitude, {"lat", "latitude_wgs84", "Breitengrad", "latitud", "lat_dd", "LAT"}},
      {ColumnRole::height,
       {"z",
        "Z_m",
        "height_msl",
        "Elevation [ft]",
        "H\xC3\xB6he \xC3\xBC. NN",
        "HOEHE",
        "H\xC3\x96HE",
        "cote NGF",
        "Cota",
        "quota s.l.m.",
        "\xC3\x89l\xC3\xA9vation",
        "elevaci\xC3\xB3n",
        "eleva\xC3\xA7\xC3\xA3o",
        "H\xC3\xB6jd",
        "h\xC3\xB8yde",
        "wysoko\xC5\x9B\xC4\x87",
        "alt",
        "Ellipsoidal height",
        "Altitude above sea level",
        "Altitud (msnm)",
        "Kote",
        "hoogte NAP"}},
      {ColumnRole::other,
       {"id", "FID", "Nr.", "Punktnummer", "Point Id", "description", "red", "Point", "OBJECTID",
        "class", "P", "D"}},
      {ColumnRole::unknown,
       {"", "first", "x_min", "sigma_x", "dx", "z error", "tree height", "antenna height",
        "height above ground", "west",
        "S\xC3\xBC"
        "d",
        "depth", "x1y", "geoid separation", "\xD0\xB2\xD1\x8B\xD1\x81\xD0\xBE"}},
  };
  for (const Case& c : cases)
    for (const char* name : c.names)
      EXPECT_EQ(static_cast<int>(role_of(name)), static_cast<int>(c.role)) << name;
}

TEST(ColumnNames, the_surest_pair_is_taken) {
  const auto found = [](std::vector<std::string> names) {
    const NamedColumns columns = find_columns(names);
    const auto text = [](const auto& column) {
      return column ? std::to_string(*column) : std::string("-");
    };
    return text(columns.x) + text(columns.y) + text(columns.z);
  };
  EXPECT_EQ(found({"lat", "lon", "h"}), "102");
  EXPECT_EQ(found({"x", "y", "east", "north", "z", "height"}), "014");
  EXPECT_EQ(found({"lat", "lon", "north", "east"}), "32-");
  EXPECT_EQ(found({"X [m]", "Y [m]", "x_rtk", "y_rtk", "Z [m]", "elev"}), "014");
  EXPECT_EQ(found({"n", "lat", "lon"}), "21-");
  EXPECT_EQ(found({"x", "northing", "z"}), "--2");
  EXPECT_EQ(found({"x", "x", "y"}), "-2-");
  EXPECT_EQ(found({"x", "y", "z", "z"}), "01-");
  EXPECT_EQ(found({"foo", "bar"}), "---");
}

TEST(ColumnNames, that_begin_like_coordinates_are_rivals) {
  const auto problem = [](const std::vector<std::string>& names) {
    return find_columns(names).plane_problem;
  };
  EXPECT_NE(
      problem({"easting_utm32n", "northing_utm32n", "easting_lv95", "northing_lv95", "height"})
          .find("'easting_lv95', 'easting_utm32n'"),
      std::string::npos);
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"x_lv95", "y_lv95", "x_plan", "y_plan"},
        {"E", "N", "E_old_system", "N_old_system"},
        {"x_lv95", "y_lv95", "Rechtswert Zone 3", "Hochwert Zone 3", "z"},
        {"lat", "lon", "lat_pulkovo", "lon_pulkovo"}})
    EXPECT_NE(problem(names), "") << listed(names);
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"x", "y", "z", "x_plan", "y_plan"},
        {"lat", "lon", "lat_std", "lon_std"},
        {"easting", "northing", "north_facing", "z"},
        {"easting", "northing", "lat_pulkovo", "lon_pulkovo"},
        {"easting", "northing", "east velocity", "north velocity"}}) {
    EXPECT_EQ(problem(names), "") << listed(names);
    EXPECT_TRUE(find_columns(names).plane()) << listed(names);
  }
}

TEST(ColumnNames, that_only_number_the_columns) {
  using Names = std::vector<std::string>;
  for (const Names& names :
       {Names{"V1", "V2", "V3"}, Names{"a", "b", "c"}, Names{"A", "B"}, Names{"field_0", "field_1"},
        Names{"Column 1", "Column 2", "Column 3"}})
    EXPECT_TRUE(only_number_columns(names)) << listed(names);
  for (const Names& names :
       {Names{}, Names{"", "", ""}, Names{"b", "c", "d"}, Names{"V2", "V1", "V3"},
        Names{"V1", "V2", "Z3"}, Names{"a", "c", "b"}, Names{"aa", "ab", "ac"},
        Names{"abszisse", "pravac", "stojka"}, Names{"V1", "V2", ""}})
    EXPECT_FALSE(only_number_columns(names)) << listed(names);
}

TEST(ColumnNames, units_are_known) {
  for (const char* unit : {"m", "M", "[deg]", "(metres)", "ft", "\xC2\xB0", "double"})
    EXPECT_TRUE(is_unit(unit)) << unit;
  for (const char* no_unit : {"", "x", "-", "NA", "1", "[]"}) EXPECT_FALSE(is_unit(no_unit));
}

}  // namespace
}  // namespace hodt
