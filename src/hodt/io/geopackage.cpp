#include "hodt/io/geopackage.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "hodt/base/buffer.h"
#include "hodt/base/error.h"
#include "hodt/base/ids.h"
#include "hodt/base/printable.h"
#include "hodt/io/crs_name.h"
#include "hodt/io/feature_file.h"
#include "hodt/io/feature_texts.h"
#include "hodt/io/formats.h"
#include "hodt/io/gdal/writers.h"
#include "hodt/io/rtree.h"
#include "hodt/io/sqlite.h"
#include "hodt/io/well_known_binary.h"

namespace hodt {

namespace {

/// Of the last change the standard wants to know the time, but the same input gives the same bytes.
constexpr const char* kNoTime = "1970-01-01T00:00:00.000Z";

/// The tables that the standard wants.
constexpr const char* kTables = R"(
  PRAGMA application_id = 1196444487;
  PRAGMA user_version = 10300;
  BEGIN;
  CREATE TABLE gpkg_spatial_ref_sys (
    srs_name TEXT NOT NULL, srs_id INTEGER NOT NULL PRIMARY KEY, organization TEXT NOT NULL,
    organization_coordsys_id INTEGER NOT NULL, definition TEXT NOT NULL, description TEXT);
  CREATE TABLE gpkg_contents (
    table_name TEXT NOT NULL PRIMARY KEY, data_type TEXT NOT NULL, identifier TEXT UNIQUE,
    description TEXT DEFAULT '',
    last_change DATETIME NOT NULL DEFAULT (strftime('%Y-%m-%dT%H:%M:%fZ','now')),
    min_x DOUBLE, min_y DOUBLE, max_x DOUBLE, max_y DOUBLE, srs_id INTEGER,
    CONSTRAINT fk_gc_r_srs_id FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys(srs_id));
  CREATE TABLE gpkg_geometry_columns (
    table_name TEXT NOT NULL, column_name TEXT NOT NULL, geometry_type_name TEXT NOT NULL,
    srs_id INTEGER NOT NULL, z TINYINT NOT NULL, m TINYINT NOT NULL,
    CONSTRAINT pk_geom_cols PRIMARY KEY (table_name, column_name),
    CONSTRAINT uk_gc_table_name UNIQUE (table_name),
    CONSTRAINT fk_gc_tn FOREIGN KEY (table_name) REFERENCES gpkg_contents(table_name),
    CONSTRAINT fk_gc_srs FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys(srs_id));
  CREATE TABLE gpkg_extensions (
    table_name TEXT, column_name TEXT, extension_name TEXT NOT NULL, definition TEXT NOT NULL,
    scope TEXT NOT NULL,
    CONSTRAINT ge_tce UNIQUE (table_name, column_name, extension_name));
  INSERT INTO gpkg_spatial_ref_sys VALUES
    ('Undefined Cartesian', -1, 'NONE', -1, 'undefined', NULL),
    ('Undefined geographic', 0, 'NONE', 0, 'undefined', NULL),
    ('WGS 84 geodetic', 4326, 'EPSG', 4326, 'GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",)"
                                R"(6378137,298.257223563,AUTHORITY["EPSG","7030"]],)"
                                R"(AUTHORITY["EPSG","6326"]],PRIMEM["Greenwich",0,)"
                                R"(AUTHORITY["EPSG","8901"]],UNIT["degree",0.0174532925199433,)"
                                R"(AUTHORITY["EPSG","9122"]],AXIS["Latitude",NORTH],)"
                                R"(AXIS["Longitude",EAST],AUTHORITY["EPSG","4326"]]', NULL);
)";

/// The triggers that keep the spatial index, as the standard's extension has them: their names,
/// when they act, and what they do.
struct Trigger {
  const char* name;
  const char* event;
  const char* action;
};
#define HODT_IS_THERE "(NEW.{geom} NOTNULL AND NOT ST_IsEmpty(NEW.{geom}))"
#define HODT_IS_NOT_THERE "(NEW.{geom} ISNULL OR ST_IsEmpty(NEW.{geom}))"
#define HODT_REMOVE "DELETE FROM {index} WHERE id = OLD.fid; "
#define HODT_PUT                                                          \
  "INSERT OR REPLACE INTO {index} VALUES (NEW.fid, ST_MinX(NEW.{geom}), " \
  "ST_MaxX(NEW.{geom}), ST_MinY(NEW.{geom}), ST_MaxY(NEW.{geom})); "
constexpr Trigger kTriggers[] = {
    {"insert", "INSERT ON {table} WHEN " HODT_IS_THERE, HODT_PUT},
    {"update1", "UPDATE OF {geom} ON {table} WHEN OLD.fid = NEW.fid AND " HODT_IS_THERE, HODT_PUT},
    {"update2", "UPDATE OF {geom} ON {table} WHEN OLD.fid = NEW.fid AND " HODT_IS_NOT_THERE,
     HODT_REMOVE},
    {"update3", "UPDATE ON {table} WHEN OLD.fid != NEW.fid AND " HODT_IS_THERE,
     HODT_REMOVE HODT_PUT},
    {"update4", "UPDATE ON {table} WHEN OLD.fid != NEW.fid AND " HODT_IS_NOT_THERE,
     "DELETE FROM {index} WHERE id IN (OLD.fid, NEW.fid); "},
    {"delete", "DELETE ON {table} WHEN OLD.{geom} NOT NULL", HODT_REMOVE},
};
#undef HODT_IS_THERE
#undef HODT_IS_NOT_THERE
#undef HODT_REMOVE
#undef HODT_PUT

std::string_view type_name(GeometryKind kind) {
  switch (kind) {
    case GeometryKind::point:
      return "POINT";
    case GeometryKind::line:
      return "LINESTRING";
    case GeometryKind::polygon:
      return "POLYGON";
  }
  return {};
}

std::string_view type_name(FieldType type) {
  switch (type) {
    case FieldType::integer:
      return "INTEGER";
    case FieldType::real:
      return "REAL";
    case FieldType::text:
      return "TEXT";
  }
  return {};
}

/// A table's name that belongs to nobody else.
std::string table_name(const std::string& layer) {
  std::string lower = layer;
  for (char& c : lower)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  for (const char* const taken : {"gpkg_", "rtree_", "sqlite_"})
    if (lower.starts_with(taken)) return fmt::format("layer_{}", layer);
  return layer;
}

/// What the standard wants to know of a system. Where it cannot be told, the number in EPSG's list
/// tells readers all the same.
std::string definition_of(const std::string& crs) {
  const std::string definition = has_gdal() ? crs_definition(crs) : "";
  if (!definition.empty()) return definition;
  return crs.find('[') != std::string::npos ? crs : "undefined";
}

/// Adds a line for the system, unless it has one; returns its number.
std::int64_t add_crs(Database& database, const std::string& crs) {
  constexpr std::int64_t undefined = -1, own = 100000;
  if (crs.empty()) return undefined;
  const CrsCode code = crs_code(crs).value_or(CrsCode{"NONE", own});
  const std::int64_t id = code.authority == "EPSG" ? code.number : own;
  const std::string name = fmt::format("{}:{}", code.authority, code.number);
  database.run(
      fmt::format("INSERT OR IGNORE INTO gpkg_spatial_ref_sys VALUES ({}, {}, {}, {}, {}, {})",
                  sql_text(name), id, sql_text(code.authority), code.number,
                  sql_text(definition_of(crs)), crs == name ? "NULL" : sql_text(crs)));
  return id;
}

/// What a geometry begins with, and its box, in front of well-known binary.
class GeometryBytes {
 public:
  GeometryBytes(const FeatureLayer& layer, std::int64_t crs)
      : has_box_(layer.geometry != GeometryKind::point), body_(layer) {
    constexpr int version = 0, little_endian = 1, with_box = 2;
    for (const int byte : {int{'G'}, int{'P'}, version, little_endian | (has_box_ ? with_box : 0)})
      head_ += static_cast<char>(byte);
    append_raw(head_, static_cast<std::int32_t>(crs));
  }

  void append(std::string& bytes, const LayerFeature& feature, const Box& box) const {
    bytes += head_;
    if (has_box_)
      for (const double side : {box.low.x, box.high.x, box.low.y, box.high.y})
        append_raw(bytes, side);
    body_.append(bytes, feature);
  }

 private:
  bool has_box_;
  std::string head_;
  WellKnownBinary body_;
};

/// Features on their way from all threads to the one that writes: a geometry and values, each
/// behind its length or kind.
class Rows {
 public:
  Rows(const FeatureLayer& layer, const GeometryBytes& geometry, Buffer<Box>& boxes)
      : layer_(layer), geometry_(geometry), boxes_(boxes) {}

  void append(std::size_t i, LayerFeature& feature, std::string& bytes) const {
    feature.values.resize(layer_.fields.size());
    layer_.make(i, feature);
    const Box box = box_of(feature.xy);
    boxes_[i] = box;
    const std::size_t start = bytes.size();
    append_raw(bytes, std::uint32_t{0});
    geometry_.append(bytes, feature, box);
    const auto size = static_cast<std::uint32_t>(bytes.size() - start - sizeof(std::uint32_t));
    std::memcpy(bytes.data() + start, &size, sizeof size);
    for (const FieldValue& value : feature.values) append_value(bytes, value);
  }

  /// Takes the first row off what `append` made.
  static void take_row(std::string_view& bytes, std::span<SqlValue> row) {
    row[0] = SqlBlob{take_bytes(bytes)};
    for (SqlValue& value : row.subspan(1)) value = take_value(bytes);
  }

 private:
  enum Kind : char { kNothing, kInteger, kReal, kText };

  static void append_value(std::string& bytes, const FieldValue& value) {
    if (const auto* const whole = std::get_if<std::int64_t>(&value)) {
      bytes += kInteger;
      append_raw(bytes, *whole);
    } else if (const auto* const real = std::get_if<double>(&value); real && std::isfinite(*real)) {
      bytes += kReal;
      append_raw(bytes, *real);
    } else if (const auto* const words = std::get_if<std::string>(&value)) {
      bytes += kText;
      append_raw(bytes, static_cast<std::uint32_t>(words->size()));
      bytes += *words;
    } else {
      bytes += kNothing;
    }
  }

  template <class T>
  static T take(std::string_view& bytes) {
    T value;
    std::memcpy(&value, bytes.data(), sizeof value);
    bytes.remove_prefix(sizeof value);
    return value;
  }
  static std::string_view take_bytes(std::string_view& bytes) {
    const auto size = take<std::uint32_t>(bytes);
    const std::string_view taken = bytes.substr(0, size);
    bytes.remove_prefix(size);
    return taken;
  }
  static SqlValue take_value(std::string_view& bytes) {
    switch (take<Kind>(bytes)) {
      case kInteger:
        return take<std::int64_t>(bytes);
      case kReal:
        return take<double>(bytes);
      case kText:
        return take_bytes(bytes);
      case kNothing:
        break;
    }
    return {};
  }

  const FeatureLayer& layer_;
  const GeometryBytes& geometry_;
  Buffer<Box>& boxes_;
};

constexpr const char* kGeometryColumn = "geom";

void create_table(Database& database, const FeatureLayer& layer, const std::string& table) {
  std::string columns = fmt::format("fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, {} {}",
                                    kGeometryColumn, type_name(layer.geometry));
  for (const Field& field : layer.fields)
    columns += fmt::format(", {} {}", sql_name(field.name), type_name(field.type));
  database.run(fmt::format("CREATE TABLE {} ({})", sql_name(table), columns));
}

void insert_features(Database& database, const FeatureLayer& layer, const std::string& table,
                     const GeometryBytes& geometry, Buffer<Box>& boxes) {
  std::string columns = kGeometryColumn;
  for (const Field& field : layer.fields) columns += ", " + sql_name(field.name);
  const std::string insertion = fmt::format("INSERT INTO {} ({})", sql_name(table), columns);
  const Rows rows(layer, geometry, boxes);
  const auto append = [&](std::size_t i, LayerFeature& feature, std::string& bytes) {
    rows.append(i, feature, bytes);
    return true;
  };
  make_feature_texts<LayerFeature>(layer.count, append, [&](std::string_view bytes) {
    database.insert(insertion, 1 + layer.fields.size(), [&](std::span<SqlValue> row) {
      if (bytes.empty()) return false;
      Rows::take_row(bytes, row);
      return true;
    });
  });
}

void fill_index(Database& database, const std::string& index, std::span<const Box> boxes) {
  const auto part = [&](const char* name) { return sql_name(fmt::format("{}_{}", index, name)); };
  database.run(fmt::format("CREATE VIRTUAL TABLE {} USING rtree(id, minx, maxx, miny, maxy)",
                           sql_name(index)));
  const auto node_size = static_cast<std::size_t>(
      database.number(fmt::format("SELECT length(data) FROM {}", part("node"))));
  const auto insert = [&](const char* name, std::int64_t first, std::size_t count,
                          const auto& value) {
    std::size_t i = 0;
    database.insert(fmt::format("INSERT OR REPLACE INTO {}", part(name)), 2,
                    [&](std::span<SqlValue> row) {
                      if (i == count) return false;
                      row[0] = first + static_cast<std::int64_t>(i);
                      row[1] = value(i++);
                      return true;
                    });
  };
  const auto insert_nodes = [&](std::int64_t first, std::string_view bytes) {
    insert("node", first, bytes.size() / node_size,
           [&](std::size_t i) { return SqlBlob{bytes.substr(i * node_size, node_size)}; });
  };
  const auto insert_links = [&](const char* name) {
    return [&insert, name](std::int64_t first, std::span<const std::int64_t> nodes) {
      insert(name, first, nodes.size(), [&](std::size_t i) { return nodes[i]; });
    };
  };
  Buffer<SmallBox> small(boxes.size());
  std::transform(boxes.begin(), boxes.end(), small.begin(), small_box);
  pack_rtree(small, node_size, {insert_nodes, insert_links("rowid"), insert_links("parent")});
}

void create_triggers(Database& database, const std::string& table, const std::string& index) {
  for (const Trigger& trigger : kTriggers) {
    const std::string text =
        fmt::format("CREATE TRIGGER {{name}} AFTER {} BEGIN {}END", trigger.event, trigger.action);
    database.run(fmt::format(fmt::runtime(text),
                             fmt::arg("name", sql_name(fmt::format("{}_{}", index, trigger.name))),
                             fmt::arg("table", sql_name(table)), fmt::arg("index", sql_name(index)),
                             fmt::arg("geom", kGeometryColumn)));
  }
}

void describe(Database& database, const FeatureLayer& layer, const std::string& table,
              std::int64_t crs, std::span<const Box> boxes) {
  std::string extent = "NULL, NULL, NULL, NULL";
  if (!boxes.empty()) {
    Box all = boxes[0];
    for (const Box& box : boxes) all = joined(all, box);
    extent = fmt::format("{}, {}, {}, {}", all.low.x, all.low.y, all.high.x, all.high.y);
  }
  database.run(
      fmt::format("INSERT INTO gpkg_contents VALUES ({}, 'features', {}, '', '{}', {}, {})",
                  sql_text(table), sql_text(table), kNoTime, extent, crs));
  database.run(fmt::format("INSERT INTO gpkg_geometry_columns VALUES ({}, '{}', '{}', {}, {}, 0)",
                           sql_text(table), kGeometryColumn, type_name(layer.geometry), crs,
                           layer.has_heights ? 1 : 0));
  database.run(
      fmt::format("INSERT INTO gpkg_extensions VALUES ({}, '{}', 'gpkg_rtree_index', "
                  "'http://www.geopackage.org/spec120/#extension_rtree', 'write-only')",
                  sql_text(table), kGeometryColumn));
}

/// The file is replaced as a whole, and with it what somebody else has put there.
void refuse_to_lose_layers(const std::filesystem::path& path, const std::string& table) {
  const std::string others = fmt::format(
      "SELECT table_name FROM gpkg_contents WHERE lower(table_name) <> lower({})", sql_text(table));
  const std::vector<std::string> lost = words_in_database(path, others);
  if (!lost.empty())
    throw FileError(
        fmt::format("cannot write {}: it holds the layer '{}'{}, which would be lost; name another "
                    "file, or remove it first",
                    path.string(), printable(lost[0]),
                    lost.size() == 1 ? "" : fmt::format(" and {} more", lost.size() - 1)));
}

}  // namespace

void write_geopackage(const FeatureLayer& layer, OutputFile& file) {
  if (file.is_replaced())
    refuse_to_lose_layers(file.path(), table_name(layer_name(layer, file.path())));
  file.fill_by_name([&](const std::filesystem::path& path) {
    Database database(path, file.path());
    database.run(kTables);
    const std::string table = table_name(layer_name(layer, file.path()));
    const std::int64_t crs = add_crs(database, layer.crs);
    create_table(database, layer, table);
    Buffer<Box> boxes(layer.count);
    insert_features(database, layer, table, GeometryBytes(layer, crs), boxes);
    describe(database, layer, table, crs, boxes);
    const std::string index = fmt::format("rtree_{}_{}", table, kGeometryColumn);
    fill_index(database, index, boxes);
    create_triggers(database, table, index);
    database.run("COMMIT");
    database.close();
  });
  file.outdate("-wal -shm -journal");  // SQLite would take it for pages of the new file
}

}  // namespace hodt
