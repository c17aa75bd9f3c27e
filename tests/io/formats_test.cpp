#include "hodt/io/formats.h"

#include <set>
#include <string>

#include "temporary_directory.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"

namespace hodt {
namespace {

constexpr Use kUses[] = {Use::read_points,  Use::read_features, Use::read_tin,
                         Use::write_points, Use::write_tin,     Use::write_features};

TEST(Formats, AreToldByTheirExtensions) {
  for (const Use use : kUses) {
    std::set<std::string> seen;
    for (const Format& format : formats()) {
      if (!can(format, use)) continue;
      for (const std::string_view each : extensions_of(format)) {
        const std::string extension(each);
        EXPECT_TRUE(seen.insert(extension).second) << extension << " is told twice";
        EXPECT_EQ(find_format("a b" + extension, use), &format);
        EXPECT_EQ(&format_for("folder.obj/a" + extension, use), &format);
      }
    }
    EXPECT_FALSE(seen.empty());
  }
  EXPECT_EQ(find_format("A.PLY", Use::write_tin), find_format("a.ply", Use::read_tin));
  EXPECT_EQ(find_format("a.geojson.gz", Use::read_features),
            find_format("a.json", Use::read_features));
  EXPECT_NE(find_format("a.xyz.gz", Use::write_points), nullptr);
}

TEST(Formats, EachCanBeUsed) {
  for (const Format& format : formats()) {
    bool is_useful = false;
    for (const Use use : kUses) is_useful = is_useful || can(format, use);
    EXPECT_TRUE(is_useful) << format.name;
  }
}

TEST(Formats, UnknownOnesAreRefusedWithTheKnownOnes) {
  const auto refusal = [](const char* path, Use use) {
    return test::message_of<ParameterError>([&] { format_for(path, use); });
  };
  EXPECT_EQ(find_format("a.ply.gz", Use::write_tin), nullptr) << "meshes are not packed";
  EXPECT_EQ(find_format("a.ply", Use::write_points), nullptr);
  EXPECT_EQ(find_format("ply", Use::read_tin), nullptr);
  EXPECT_NE(refusal("a.stl1", Use::write_tin)
                .find("cannot write a mesh to a.stl1: unknown extension '.stl1'; known are .obj, "),
            std::string::npos);
  EXPECT_NE(refusal("mesh", Use::write_tin).find("the name has no extension"), std::string::npos);
  EXPECT_EQ(refusal("a.ply", Use::write_points),
            "cannot write points to a.ply: unknown extension '.ply'; known are .csv, .xyz, each "
            "also with .gz");
}

}  // namespace
}  // namespace hodt
