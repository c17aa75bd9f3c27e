// Files that GDAL's own programs make, for whoever reads them through hodt.
#pragma once

#include <cstdlib>
#include <string>

#include "temporary_directory.h"
#include <gtest/gtest.h>

#include "hodt/io/formats.h"

namespace hodt::test {

/// Skipped where hodt was built without GDAL, or its programs (Debian's gdal-bin) are missing.
class GdalFiles : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_gdal()) GTEST_SKIP() << "built without GDAL";
    if (std::system("ogr2ogr --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no ogr2ogr";
  }

  /// Runs a command of the shell in the directory.
  void shell(const std::string& command) const {
    const std::string line =
        "cd '" + directory_.path().string() + "' && { " + command + "; } >/dev/null 2>&1";
    ASSERT_EQ(std::system(line.c_str()), 0) << command;
  }

  /// A layer of a file, which may be there already, of a table with a column wkt.
  void layer(const std::string& format, const std::string& file, const std::string& name,
             const std::string& table, const std::string& more = "") const {
    // Of a table with one column GDAL makes nothing.
    const bool is_alone = table.starts_with("wkt\n");
    std::string text = table;
    for (std::size_t at = 0; is_alone && (at = text.find('\n', at)) != text.npos; at += 3)
      text.insert(at, at == 3 ? ",n" : ",0");
    directory_.file("table.csv", text);
    shell("ogr2ogr -append -f '" + format + "' '" + file +
          "' table.csv -oo GEOM_POSSIBLE_NAMES=wkt -oo KEEP_GEOM_COLUMNS=NO -oo "
          "AUTODETECT_TYPE=YES -nln '" +
          name + "' " + more);
  }

  /// A raster in the GeoTIFF `file` of an ESRI ASCII grid's text.
  void raster(const std::string& file, const std::string& grid, const std::string& more) const {
    directory_.file("grid.asc", grid);
    shell("gdal_translate -oo DATATYPE=Float64 grid.asc '" + file + "' " + more);
  }

  TemporaryDirectory directory_;
};

}  // namespace hodt::test
