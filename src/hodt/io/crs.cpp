#include "hodt/io/crs.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/crs_name.h"
#include "hodt/io/formats.h"
#include "hodt/io/gdal/crs_facts.h"

namespace hodt {

namespace {

bool is_word(std::string_view text, bool (*belongs)(char)) {
  return !text.empty() && std::all_of(text.begin(), text.end(), belongs);
}

bool is_digit(char c) {
  return '0' <= c && c <= '9';
}

char upper(char c) {
  return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

/// "epsg:25832" as "EPSG:25832", and "EPSG:25832+7837"; empty for any other text.
std::string code_of(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == text.npos) return {};
  std::string code = text;
  std::transform(code.begin(), code.end(), code.begin(), upper);
  const std::string_view authority = std::string_view(code).substr(0, colon);
  const std::string_view number = std::string_view(code).substr(colon + 1);
  const auto is_letter = [](char c) { return 'A' <= c && c <= 'Z'; };
  const auto belongs = [](char c) { return is_digit(c) || ('A' <= c && c <= 'Z') || c == '+'; };
  return is_word(authority, is_letter) && is_word(number, belongs) ? code : std::string();
}

bool is_epsg_number(std::string_view code) {
  constexpr std::string_view authority = "EPSG:";
  return code.starts_with(authority) && is_word(code.substr(authority.size()), is_digit);
}

std::vector<std::string> height_warnings_of(const CrsFacts& facts, double unit,
                                            const std::string& name) {
  if (unit == 0 || is_same_unit(unit, facts.unit)) return {};
  return {fmt::format(
      "heights are in {}, x and y in {} ({}), so that slopes, and measures that use heights, are "
      "not those on the ground; bring them to one unit first, with ogr2ogr -t_srs EPSG:... for "
      "example",
      name, facts.unit_name, facts.name)};
}

}  // namespace

std::string parse_crs(std::string_view option, const std::string& text) {
  const std::string code = code_of(text);
  // Anything else could be the name of a file or an address.
  const bool is_definition = is_wkt(text) || text.starts_with("+proj=");
  const bool has_form = has_gdal() ? !code.empty() || is_definition : is_epsg_number(code);
  const std::string known = code.empty() ? text : code;
  const std::optional<CrsFacts> facts = has_form ? crs_facts(known) : std::nullopt;
  if (!has_form || (has_gdal() && !facts))
    throw ParameterError(fmt::format(
        "{} must be a coordinate reference system that is known, like EPSG:25832, not "
        "'{}'{}",
        option, text, has_gdal() ? "" : "; without GDAL hodt understands nothing but EPSG:number"));
  if (facts && !facts->is_plane)
    throw ParameterError(fmt::format(
        "{} must be a coordinate reference system of x and y, like EPSG:25832, and '{}' ({}) is "
        "geocentric or of heights alone",
        option, text, facts->name));
  return facts ? facts->text : known;
}

bool is_same_crs(const std::string& a, const std::string& b) {
  return a == b || are_equal_crs(a, b);
}

bool tells_heights(const std::string& crs) {
  const std::optional<CrsFacts> facts = crs.empty() ? std::nullopt : crs_facts(crs);
  return facts && facts->has_heights;
}

bool is_same_unit(double a, double b) {
  return std::fabs(a - b) < 1e-5 * b;
}

std::string crs_title(const std::string& crs) {
  const std::optional<CrsFacts> facts = crs.empty() ? std::nullopt : crs_facts(crs);
  if (!facts) return crs;
  return code_of(facts->text).empty() ? facts->name
                                      : fmt::format("{} ({})", facts->text, facts->name);
}

std::string degrees_warning(const std::string& why) {
  return fmt::format(
      "x and y are degrees ({}), which are not of the same length, so that circles, lengths and "
      "angles are not those on the ground; bring the data to a system in metres first, with "
      "ogr2ogr -t_srs EPSG:... or, for rasters, gdalwarp -t_srs EPSG:...",
      why);
}

std::vector<std::string> crs_warnings(const std::string& crs) {
  const std::optional<CrsFacts> facts = crs.empty() ? std::nullopt : crs_facts(crs);
  if (!facts) return {};
  if (facts->is_geographic) return {degrees_warning(facts->name)};
  return height_warnings_of(*facts, facts->height_unit, facts->height_unit_name);
}

std::vector<std::string> height_warnings(const std::string& crs, double unit,
                                         const std::string& name) {
  const std::optional<CrsFacts> facts = crs.empty() ? std::nullopt : crs_facts(crs);
  // Degrees have a warning of their own, and so has what the system itself says.
  if (!facts || facts->is_geographic || is_same_unit(unit, facts->height_unit)) return {};
  return height_warnings_of(*facts, unit, name);
}

std::string crs_with_heights(const std::string& crs, long heights) {
  if (!is_epsg_number(crs)) return {};
  const std::optional<CrsFacts> facts = crs_facts(fmt::format("{}+{}", crs, heights));
  return facts ? facts->text : std::string();
}

CrsUnits crs_units(const std::string& crs) {
  const std::optional<CrsFacts> facts = crs.empty() ? std::nullopt : crs_facts(crs);
  if (!facts) return {};
  const auto short_name = [&](double unit, const std::string& name) -> std::string {
    if (is_same_unit(unit, 1)) return "m";
    return is_same_unit(unit, 0.3048) ? "ft" : name;
  };
  CrsUnits units;
  units.metres = facts->height_unit;
  if (!facts->is_geographic) units.horizontal_metres = facts->unit;
  units.horizontal = facts->is_geographic ? "°" : short_name(facts->unit, facts->unit_name);
  if (facts->height_unit != 0)
    units.vertical = short_name(facts->height_unit, facts->height_unit_name);
  return units;
}

std::string crs_of_urn(const std::string& text) {
  constexpr std::string_view start = "urn:ogc:def:crs:";
  if (!text.starts_with(start)) return code_of(text).empty() ? text : code_of(text);
  // urn:ogc:def:crs:AUTHORITY:VERSION:CODE
  const std::string_view rest = std::string_view(text).substr(start.size());
  const std::size_t colon = rest.find(':');
  const std::size_t last = rest.rfind(':');
  if (colon == rest.npos || last == colon) return text;
  return fmt::format("{}:{}", rest.substr(0, colon), rest.substr(last + 1));
}

}  // namespace hodt
