// Coordinate reference systems, as hodt carries them: a text, "EPSG:25832" where there is a code,
// else WKT; empty if unknown.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hodt {

/// What a user names a system by: "EPSG:25832", "EPSG:25832+7837" with heights, WKT in one line, or
/// a text of PROJ. Returns how hodt carries it. Throws ParameterError if there is none of the name;
/// without GDAL only the form of "EPSG:25832" is checked, and nothing else is known.
std::string parse_crs(std::string_view option, const std::string& text);

/// Whether both are known to be the same system; without GDAL, whether they are the same text.
bool is_same_crs(const std::string& a, const std::string& b);

/// Whether a system tells of heights, too; false without GDAL.
bool tells_heights(const std::string& crs);

/// Whether two units, in metres, are the same; the two kinds of feet are.
bool is_same_unit(double a, double b);

/// The name of a system: "EPSG:25832 (ETRS89 / UTM zone 32N)"; without GDAL the text.
std::string crs_title(const std::string& crs);

/// What does not go well with triangulations, each a sentence that names a remedy: degrees, and
/// heights of other units than x and y. Without GDAL nothing is known.
std::vector<std::string> crs_warnings(const std::string& crs);

/// The first of these, of x and y that are degrees by `why`: a system's name, or a word.
std::string degrees_warning(const std::string& why);

/// The same where the file, not the system, says what heights are counted in: in `unit` metres,
/// called `name`.
std::vector<std::string> height_warnings(const std::string& crs, double unit,
                                         const std::string& name);

/// The system of x and y and one of heights, of which EPSG has the number, as one; empty if there
/// is none, and without GDAL.
std::string crs_with_heights(const std::string& crs, long heights);

/// What the coordinates are counted in: "m", "ft", "°", or the unit's name; empty if unknown.
struct CrsUnits {
  std::string horizontal, vertical;
  double metres = 0;             ///< of the vertical one; 0 if unknown
  double horizontal_metres = 0;  ///< 0 if unknown, or degrees
};
CrsUnits crs_units(const std::string& crs);

/// The text of a code in a name of OGC: "EPSG:25832" for "urn:ogc:def:crs:EPSG::25832"; any other
/// text stays.
std::string crs_of_urn(const std::string& text);

}  // namespace hodt
