// Real pits that stay.
#include <string>

#include "command_fixture.h"

namespace hodt::test {
namespace {

class KeepCommand : public CommandTest {
 protected:
  /// Local minima of the result, interior and boundary, and how many were kept.
  struct Counts {
    int before, after, kept, bound;
  };
  Counts counts(const std::string& options) const {
    const Outcome outcome = shell(
        "HODT sample jacksboro -n 2000 | HODT triangulate - -o t.obj -k 6 --json - " + options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json report = Json::parse(outcome.out);
    return {report["value"]["delaunay"], report["value"]["result"], report["kept"],
            report["value"]["bound"]};
  }
};

TEST_F(KeepCommand, deep_pits_stay) {
  const Counts all = counts("");
  EXPECT_EQ(all.kept, 0);
  EXPECT_LT(all.after, all.before);
  const Counts deep = counts("--min-pit-depth 5");
  EXPECT_GT(deep.kept, 0);
  EXPECT_GE(deep.after, deep.kept);
  EXPECT_GE(deep.bound, deep.kept);
  EXPECT_GT(deep.after, all.after);
  EXPECT_LT(deep.after, deep.before);
  const Counts hardly_any = counts("--min-pit-depth 1e9");
  EXPECT_EQ(hardly_any.kept, 0);
  EXPECT_EQ(hardly_any.after, all.after);
}

TEST_F(KeepCommand, an_outline_keeps_all_in_it_and_a_point_its_pit) {
  ASSERT_EQ(shell("echo '{\"type\": \"Polygon\", \"coordinates\": [[[-1e9, -1e9], [1e9, -1e9], "
                  "[1e9, 1e9], [-1e9, 1e9], [-1e9, -1e9]]]}' > all.geojson && "
                  "HODT sample jacksboro -n 2000 | head -2 > one.csv")
                .exit_code,
            0);
  const Counts all = counts("--keep all.geojson");
  EXPECT_EQ(all.kept, all.before);
  EXPECT_EQ(all.after, all.before);
  EXPECT_EQ(counts("--keep one.csv").kept, 1);
}

TEST_F(KeepCommand, errors_say_what_is_wrong) {
  ASSERT_EQ(shell("echo nonsense > bad.geojson; echo '{\"type\": \"LineString\"}' > line.geojson; "
                  "HODT sample jacksboro -n 100 > p.csv")
                .exit_code,
            0);
  expect_refused("triangulate p.csv -o t.obj --keep bad.geojson", "no GeoJSON");
  expect_refused("triangulate p.csv -o t.obj --keep line.geojson", "LineString");
  expect_refused("triangulate - -o t.obj --keep -", "both be standard input");
  expect_refused("triangulate p.csv -o t.obj --keep none.geojson", "none.geojson");
  expect_refused("triangulate p.csv -o t.obj --keep p.csv --json p.csv", "p.csv is the input");
  expect_refused("triangulate p.csv -o t.obj --min-pit-depth deep", "--min-pit-depth");
  expect_refused("triangulate p.csv -o t.obj --min-pit-depth 1 --objective min-max-angle",
                 "min-max-angle");
}

}  // namespace
}  // namespace hodt::test
