// What a GeoPackage holds beside its features, looked at by Python's sqlite3.
#include "hodt/io/geopackage.h"

#include <cstdlib>
#include <filesystem>
#include <string>

#include "ogr.h"
#include "sample_tins.h"
#include "temporary_directory.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/io/feature_file.h"
#include "hodt/io/tin_file.h"

namespace hodt {
namespace {

using test::TemporaryDirectory;

/// What the standard asks for, and an index whose boxes are those of the geometries.
constexpr const char* kLook = R"look(
import sqlite3, struct, sys
database = sqlite3.connect(sys.argv[1])
def values(query): return [row[0] if len(row) == 1 else row for row in database.execute(query)]
def name(text): return '"' + text.replace('"', '""') + '"'
assert values("PRAGMA application_id") == [0x47504B47]
assert values("PRAGMA user_version") == [10300]
assert values("PRAGMA integrity_check") == ["ok"]
assert values("PRAGMA foreign_key_check") == []
(table, kind, min_x, min_y, max_x, max_y, crs), = values(
    "SELECT table_name, data_type, min_x, min_y, max_x, max_y, srs_id FROM gpkg_contents")
assert kind == "features"
(column, geometry, own_crs, z, m), = values(
    "SELECT column_name, geometry_type_name, srs_id, z, m FROM gpkg_geometry_columns")
assert own_crs == crs and (z, m) == (1, 0) and geometry == "POLYGON"
assert {-1, 0, 4326, crs} == set(values("SELECT srs_id FROM gpkg_spatial_ref_sys"))
assert values("SELECT extension_name, scope FROM gpkg_extensions") == [("gpkg_rtree_index", "write-only")]
rtree = "rtree_%s_%s" % (table, column)
assert values("SELECT rtreecheck('%s')" % rtree.replace("'", "''")) == ["ok"]

def box(blob):
    assert blob[:4] == b"GP\x00\x03", blob[:4]
    assert struct.unpack_from("<i", blob, 4) == (crs,)
    return struct.unpack_from("<4d", blob, 8)
def corners(blob):
    order, kind, rings, count = struct.unpack_from("<BIII", blob, 40)
    assert (order, kind, rings, count) == (1, 1003, 1, 4)
    return [struct.unpack_from("<3d", blob, 53 + 24 * i) for i in range(count)]
boxes = {}
for fid, blob in values("SELECT fid, %s FROM %s" % (column, name(table))):
    x, y, _ = zip(*corners(blob))
    boxes[fid] = box(blob)
    assert boxes[fid] == (min(x), max(x), min(y), max(y))
assert sorted(boxes) == list(range(1, len(boxes) + 1))
all = list(zip(*boxes.values()))
assert (min_x, max_x, min_y, max_y) == (min(all[0]), max(all[1]), min(all[2]), max(all[3]))
index = {row[0]: row[1:] for row in values("SELECT * FROM " + name(rtree))}
assert index.keys() == boxes.keys()
for fid, (x0, x1, y0, y1) in boxes.items():
    a0, a1, b0, b1 = index[fid]
    assert a0 <= x0 and x1 <= a1 and b0 <= y0 and y1 <= b1
    assert max(x0 - a0, a1 - x1) <= 0.07 and max(y0 - b0, b1 - y1) <= 0.6, "single precision"
# The triggers, with functions as a GIS has them.
for i, function in enumerate(["ST_MinX", "ST_MaxX", "ST_MinY", "ST_MaxY"]):
    database.create_function(function, 1, lambda blob, i=i: box(blob)[i])
database.create_function("ST_IsEmpty", 1, lambda blob: 0)
middle = (min_x + max_x) / 2, (min_y + max_y) / 2
inside = "SELECT id FROM %s WHERE minx <= %r AND maxx >= %r AND miny <= %r AND maxy >= %r" % (
    name(rtree), middle[0], middle[0], middle[1], middle[1])
there = values(inside)
assert there
for fid in there: database.execute("DELETE FROM %s WHERE fid = %d" % (name(table), fid))
assert values(inside) == []
blob, = values("SELECT %s FROM %s WHERE fid = %d" % (column, name(table), min(set(boxes) - set(there))))
new = database.execute("INSERT INTO %s (%s) VALUES (?)" % (name(table), column), (blob,)).lastrowid
assert new == len(boxes) + 1, new
assert len(values("SELECT id FROM %s WHERE id = %d" % (name(rtree), new))) == 1
database.execute("UPDATE %s SET fid = fid + 5 WHERE fid = %d" % (name(table), new))
assert len(values("SELECT id FROM %s WHERE id = %d" % (name(rtree), new + 5))) == 1
database.execute("UPDATE %s SET %s = NULL WHERE fid = %d" % (name(table), column, new + 5))
assert values("SELECT id FROM %s WHERE id = %d" % (name(rtree), new + 5)) == []
assert values("SELECT rtreecheck('%s')" % rtree.replace("'", "''")) == ["ok"]
)look";

TEST(GeoPackage, IsAsTheStandardWants) {
  if (std::system("python3 -c 'import sqlite3' 2>/dev/null") != 0)
    GTEST_SKIP() << "needs Python's sqlite3";
  const TemporaryDirectory directory;
  const auto script = directory.file("look.py", kLook);
  // Of one node, of two levels, of three; the names need quotes.
  for (const std::size_t points : {10, 100, 3000})
    for (const char* name : {"a", "gpkg_a", "a \"b\" \xc3\xb6; select"}) {
      const auto path = directory / (std::string(name) + ".gpkg");
      write_tin(test::survey(points), path);
      const std::string quoted = "'" + path.string() + "'";
      EXPECT_EQ(test::printed_by("python3 '" + script.string() + "' " + quoted + " 2>&1 || echo x"),
                "")
          << name << ' ' << points;
    }
}

TEST(GeoPackage, TakesThePlaceOfAllOfAnOldOne) {
  const TemporaryDirectory directory;
  const auto path = directory / "a.gpkg";
  write_tin(test::survey(10), path);
  for (const char* beside : {"-wal", "-shm", "-journal"})
    directory.file(std::string("a.gpkg") + beside, "pages of the old file");
  directory.file("b.gpkg-wal", "pages of another");
  write_tin(test::survey(10), path);
  EXPECT_EQ(directory.entries(), 2u);
}

/// A point that is nowhere special.
FeatureLayer layer_of_a_point(const std::string& name) {
  FeatureLayer layer;
  layer.name = name;
  layer.count = 1;
  layer.has_heights = false;
  layer.make = [](std::size_t, LayerFeature& feature) { feature.xy.assign({{1, 2}}); };
  return layer;
}

TEST(GeoPackage, DoesNotTakeThePlaceOfOtherLayers) {
  const TemporaryDirectory directory;
  const auto path = directory / "a.gpkg";
  write_features(layer_of_a_point("it's roads"), path);
  const std::string before = test::content_of(path);
  const std::string message =
      test::message_of<FileError>([&] { write_features(layer_of_a_point("a"), path); });
  EXPECT_NE(
      message.find("a.gpkg: it holds the layer 'it's roads', which would be lost; name another "
                   "file, or remove it first"),
      std::string::npos)
      << message;
  EXPECT_EQ(test::content_of(path), before);
  EXPECT_EQ(directory.entries(), 1u);
  write_features(layer_of_a_point("it's roads"), path);  // its own place
  write_features(layer_of_a_point("IT'S roads"), path);  // names of tables have no case
  std::filesystem::copy(path, directory / "b.gpkg");
  write_features(layer_of_a_point("a"), directory / "c.gpkg");
  directory.file("d.gpkg", "no database");
  write_features(layer_of_a_point("a"), directory / "d.gpkg");
  directory.file("e.gpkg", "");
  write_features(layer_of_a_point("a"), directory / "e.gpkg");
}

TEST(GeoPackage, LeavesARefusedOneAsItIs) {
  if (std::system("python3 -c 'import sqlite3' 2>/dev/null") != 0)
    GTEST_SKIP() << "needs Python's sqlite3";
  const TemporaryDirectory directory;
  const auto path = directory / "a %41?#.gpkg";
  write_features(layer_of_a_point("roads"), path);
  test::printed_by(
      "python3 -c 'import sqlite3, sys; d = sqlite3.connect(sys.argv[1]); "
      "d.execute(\"PRAGMA journal_mode = WAL\"); d.close()' '" +
      path.string() + "' 2>&1");
  EXPECT_THROW(write_features(layer_of_a_point("a"), path), FileError);
  EXPECT_EQ(directory.entries(), 1u);
}

TEST(GeoPackage, SeesOtherLayersInAnOpenJournal) {
  if (std::system("python3 -c 'import sqlite3' 2>/dev/null") != 0)
    GTEST_SKIP() << "needs Python's sqlite3";
  const TemporaryDirectory directory;
  const auto path = directory / "a.gpkg";
  write_features(layer_of_a_point("a"), path);
  // As a program that ended without closing it.
  const auto script = directory.file("add.py", R"add(
import os, sqlite3, sys
database = sqlite3.connect(sys.argv[1])
database.execute("PRAGMA journal_mode = WAL")
database.execute("INSERT INTO gpkg_contents (table_name, data_type, identifier) VALUES ('roads', 'attributes', 'roads')")
database.commit()
os._exit(0)
)add");
  test::printed_by("python3 '" + script.string() + "' '" + path.string() + "' 2>&1");
  ASSERT_TRUE(std::filesystem::exists(directory / "a.gpkg-wal"));
  const std::string message =
      test::message_of<FileError>([&] { write_features(layer_of_a_point("a"), path); });
  EXPECT_NE(message.find("it holds the layer 'roads'"), std::string::npos) << message;
}

/// A million are made and written in many batches.
TEST(GeoPackage, HasManyFeaturesInTheirOrder) {
  if (std::system("python3 -c 'import sqlite3' 2>/dev/null") != 0)
    GTEST_SKIP() << "needs Python's sqlite3";
  const TemporaryDirectory directory;
  FeatureLayer layer;
  layer.count = 70000;
  layer.has_heights = false;
  layer.fields = {{"number", FieldType::integer}};
  layer.make = [](std::size_t i, LayerFeature& feature) {
    feature.xy.assign({{double(i), double(i % 300)}});
    feature.values[0] = std::int64_t(i);
  };
  write_features(layer, directory / "many.gpkg");
  const auto script = directory.file("look.py", R"look(
import sqlite3, struct, sys
rows = sqlite3.connect(sys.argv[1]).execute("SELECT fid, number, geom FROM many ORDER BY fid").fetchall()
assert len(rows) == 70000
for i, (fid, number, geom) in enumerate(rows):
    assert (fid, number) == (i + 1, i) and struct.unpack("<2d", geom[-16:]) == (i, i % 300), i
)look");
  EXPECT_EQ(test::printed_by("python3 '" + script.string() + "' '" +
                             (directory / "many.gpkg").string() + "' 2>&1 || echo x"),
            "");
}

}  // namespace
}  // namespace hodt
