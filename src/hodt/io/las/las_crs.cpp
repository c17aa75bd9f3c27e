#include "hodt/io/las/las_crs.h"

#include <cctype>
#include <cstdint>

#include <fmt/format.h>

#include "hodt/io/las/little_endian.h"

namespace hodt::las {

namespace {

constexpr std::string_view kProjection = "LASF_Projection";
constexpr std::uint16_t kGeoKeys = 34735, kWkt = 2112;

std::string crs_in_wkt(std::string_view content) {
  const std::string_view text = content.substr(0, std::min(content.find('\0'), content.size()));
  const std::string code = epsg_code_in_wkt(text);
  return code.empty() ? std::string(text) : "EPSG:" + code;
}

/// The value of a GeoKey that stands in the directory itself; 0 if there is none.
std::uint16_t geo_key(std::string_view directory, std::uint16_t key) {
  constexpr std::size_t entry = 8;
  // The first entry tells the version and the number of keys.
  for (std::size_t at = entry; at + entry <= directory.size(); at += entry) {
    const char* const from = directory.data() + at;
    const bool is_here = number_at<std::uint16_t>(from + 2) == 0;
    if (is_here && number_at<std::uint16_t>(from) == key) return number_at<std::uint16_t>(from + 6);
  }
  return 0;
}

std::string crs_in_geo_keys(std::string_view directory) {
  constexpr std::uint16_t projected = 3072, geographic = 2048, user_defined = 32767;
  for (const std::uint16_t key : {projected, geographic}) {
    const std::uint16_t code = geo_key(directory, key);
    if (code == user_defined) return {};
    if (code != 0) return fmt::format("EPSG:{}", code);
  }
  return {};
}

/// Walks through well-known text: NAME["text", 1, INNER[...]].
class WktWalk {
 public:
  explicit WktWalk(std::string_view text) : text_(text) {}

  /// The code in the last AUTHORITY["EPSG", "1"] or ID["EPSG", 1] of the outermost brackets.
  std::string outer_epsg_code() {
    std::string code;
    std::size_t word = 0;  // where the word before the next bracket begins
    int depth = 0;
    for (std::size_t i = 0; i < text_.size(); ++i) {
      const char c = text_[i];
      if (c == '"') {
        i = std::min(text_.find('"', i + 1), text_.size());
      } else if (c == '[' || c == '(') {
        const std::string_view name = text_.substr(word, i - word);
        if (++depth == 2 && (name == "AUTHORITY" || name == "ID")) code = epsg_code(i + 1);
      } else if (c == ']' || c == ')') {
        --depth;
      }
      if (std::isalnum(static_cast<unsigned char>(c)) == 0) word = i + 1;
    }
    return code;
  }

 private:
  /// Of "EPSG", "25832"] the digits.
  std::string epsg_code(std::size_t begin) const {
    constexpr std::string_view authority = "\"EPSG\"";
    std::string_view rest = text_.substr(begin);
    rest = rest.substr(std::min(rest.find_first_not_of(" \t\r\n"), rest.size()));
    if (!rest.starts_with(authority)) return {};
    rest.remove_prefix(authority.size());
    const std::size_t digits = std::min(rest.find_first_not_of(" \t\r\n,\""), rest.size());
    rest.remove_prefix(digits);
    return std::string(rest.substr(0, std::min(rest.find_first_not_of("0123456789"), rest.size())));
  }

  std::string_view text_;
};

/// A file may have both; its header says which one is meant.
bool takes_keys(const LasHeader& header) {
  const bool has_wkt = !crs_in_wkt(header.content_of(kProjection, kWkt)).empty();
  const bool has_keys = !crs_in_geo_keys(header.content_of(kProjection, kGeoKeys)).empty();
  return header.prefers_wkt ? !has_wkt : has_keys;
}

}  // namespace

std::string epsg_code_in_wkt(std::string_view text) {
  return WktWalk(text).outer_epsg_code();
}

std::string crs_of(const LasHeader& header) {
  return takes_keys(header) ? crs_in_geo_keys(header.content_of(kProjection, kGeoKeys))
                            : crs_in_wkt(header.content_of(kProjection, kWkt));
}

LasHeights heights_of(const LasHeader& header) {
  constexpr std::uint16_t system = 4096, unit = 4099, user_defined = 32767;
  if (!takes_keys(header)) return {};
  const std::string_view directory = header.content_of(kProjection, kGeoKeys);
  const auto said = [&](std::uint16_t key) {
    const std::uint16_t value = geo_key(directory, key);
    return value == user_defined ? std::uint16_t{0} : value;
  };
  return {said(system), said(unit)};
}

}  // namespace hodt::las
