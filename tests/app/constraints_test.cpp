// Breaklines, outlines, edges that stay, and meshes to improve: the command. Covers
// constraints_input.
#include <sstream>
#include <string>

#include "command_fixture.h"

namespace hodt::test {
namespace {

/// A square of 4 × 4 points, row by row, and lines on it.
class ConstraintsCommand : public CommandTest {
 protected:
  void SetUp() override {
    std::string table = "x,y,z\n";
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 4; ++x)
        table += std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(x + y) + "\n";
    put("points.csv", table);
    put("road.geojson", line("[[0,0.5,7],[2.5,1.75,8]]"));
    put("soft.geojson", line("[[0.5,0.5],[2.5,0.5]]"));
    put("cross.geojson", line("[[0.25,3],[2.75,0]]"));
    put("site.geojson", R"({"type":"Polygon","coordinates":[[[0,0],[3,0],[3,3],[0,0]]]})");
  }
  static std::string line(const std::string& coordinates) {
    return R"({"type":"LineString","coordinates":)" + coordinates + "}";
  }
};

TEST_F(ConstraintsCommand, keeps_breaklines_and_tells_what_they_brought) {
  const Outcome outcome =
      run("triangulate points.csv --breaklines road.geojson --breaklines soft.geojson -o a.ply "
          "--json a.json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json constraints = json("a.json")["constraints"];
  EXPECT_EQ(constraints["edges"], 2);
  EXPECT_EQ(constraints["edges_kept"], 3);  // the road passes through a point
  EXPECT_EQ(constraints["vertices_added"], 4);
  EXPECT_EQ(constraints["vertices_from_surface"], 2);
  EXPECT_EQ(json("a.json")["points"], 20);
  EXPECT_NE(outcome.out.find("constraints"), std::string::npos);
  // And the mesh has them.
  EXPECT_EQ(run("check a.ply --breaklines road.geojson --breaklines soft.geojson -k 4").exit_code,
            0);
  put("other.geojson", line("[[0,3],[3,0]]"));
  EXPECT_EQ(run("check a.ply --breaklines other.geojson").exit_code, 1);
}

TEST_F(ConstraintsCommand, leaves_out_what_is_outside) {
  ASSERT_EQ(run("triangulate points.csv --outline site.geojson -o a.ply --json a.json").exit_code,
            0);
  const Json report = json("a.json");
  EXPECT_EQ(report["constraints"]["triangles_outside"], 9);
  EXPECT_EQ(report["constraints"]["points_left_out"], 6);
  EXPECT_EQ(report["triangles"], 9);
}

TEST_F(ConstraintsCommand, tells_of_lines_that_are_lost) {
  put("far.csv", "x,y,z\n0,0,1\n1,0,2\n0,1,3\n1,1,4\n20,0.4,0\n20.5,0.9,0\n");
  put("keep.csv", "u,v\n3,4\n");
  const Outcome cut =
      run("triangulate far.csv -o a.ply --max-edge 3 --keep-edges keep.csv -k 0 --json a.json");
  ASSERT_EQ(cut.exit_code, 0) << cut.err;
  EXPECT_EQ(json("a.json")["constraints"]["edges_left_out"], 1);
  EXPECT_NE(cut.out.find("1 edge of lines"), std::string::npos) << cut.out;
  put("short.geojson", line("[[0.9,0.1],[1.1,0.1],[1,0.9]]"));
  const Outcome snapped =
      run("triangulate far.csv -o a.ply --breaklines short.geojson --snap 0.3 --json a.json");
  ASSERT_EQ(snapped.exit_code, 0) << snapped.err;
  EXPECT_EQ(json("a.json")["constraints"]["pieces_snapped_away"], 1);
  EXPECT_NE(snapped.out.find("1 piece with both ends to the same one: gone"), std::string::npos)
      << snapped.out;
}

TEST_F(ConstraintsCommand, names_lines_that_cross) {
  put("other.geojson", line("[[0.5,2.75],[0.5,0.25]]"));
  expect_refused(
      "triangulate points.csv --breaklines cross.geojson --breaklines other.geojson -o a.ply",
      "lines cross near x 0.5, y 2.7: that of cross.geojson, feature 1, between x 0.25, "
      "y 3 and x 2.75, y 0, and that of other.geojson");
  const Outcome outcome =
      run("triangulate points.csv --breaklines cross.geojson --breaklines other.geojson "
          "--split-crossings -o a.ply --json a.json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(json("a.json")["constraints"]["vertices_at_crossings"], 1);
}

TEST_F(ConstraintsCommand, keeps_edges_by_their_rows) {
  put("edges.csv", "u,v\n0,5\n3,6\n");
  ASSERT_EQ(run("triangulate points.csv --keep-edges edges.csv -o a.ply --json a.json").exit_code,
            0);
  EXPECT_EQ(json("a.json")["constraints"]["edges_kept"], 2);
  put("far.csv", "u,v\n0,5\n3,16\n");
  expect_refused("triangulate points.csv --keep-edges far.csv -o a.ply", "far.csv, line 3: there");
}

TEST_F(ConstraintsCommand, improves_a_mesh) {
  ASSERT_EQ(
      run("triangulate points.csv --outline site.geojson -o a.obj --objective none").exit_code, 0);
  const Outcome outcome =
      run("triangulate a.obj -o b.obj --objective min-sum-length --json b.json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json report = json("b.json");
  EXPECT_EQ(report["columns"], nullptr);
  EXPECT_EQ(report["input"]["order"], 0);
  EXPECT_EQ(report["triangles"], 9);
  EXPECT_EQ(report["value"]["input"], report["value"]["delaunay"]);
  expect_refused("triangulate a.obj --outline site.geojson -o c.obj", "the outline of a.obj stays");
  expect_refused("triangulate a.obj --columns x=1,y=2,z=3 -o c.obj", "a.obj is a mesh");
}

/// Edges to keep go by the mesh's own vertices, also if some of these are of no triangle.
TEST_F(ConstraintsCommand, counts_vertices_of_a_mesh_as_the_file_does) {
  put("mesh.obj", "v 9 9 0\nv 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 2 3 4\nf 2 4 5\n");
  put("other.csv", "u,v\n2,4\n");
  const Outcome outcome = run(
      "triangulate mesh.obj --keep-edges other.csv --objective none -o b.obj --json b.json && cat "
      "b.obj");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(json("b.json")["constraints"]["edges_kept"], 5);
  EXPECT_EQ(json("b.json")["input"]["unused_vertices"], 1);
  EXPECT_NE(outcome.out.find("f "), std::string::npos);
  // The vertices that are left are 1 to 4; 1 and 3 are not in one triangle.
  std::istringstream lines(outcome.out);
  int faces = 0;
  for (std::string text; std::getline(lines, text);) {
    if (!text.starts_with("f ")) continue;
    ++faces;
    EXPECT_TRUE(text.find('1') == std::string::npos || text.find('3') == std::string::npos) << text;
  }
  EXPECT_EQ(faces, 2);
  put("unused.csv", "u,v\n0,1\n");
  expect_refused("triangulate mesh.obj --keep-edges unused.csv -o c.obj", "unused.csv, line 2");
}

TEST_F(ConstraintsCommand, refuses_what_it_cannot_use) {
  expect_refused("triangulate points.csv --breaklines none.geojson -o a.ply", "none.geojson");
  put("far.geojson", line("[[50,50],[60,60]]"));
  expect_refused(
      "triangulate points.csv --breaklines far.geojson -o a.ply",
      "far.geojson: its lines, with x from 50 to 60 and y from 50 to 60, are nowhere near");
  put("near.geojson", line("[[1,1],[6,1]]"));
  expect_refused("triangulate points.csv --breaklines near.geojson -o a.ply",
                 "near.geojson, feature 1: its vertex at x 6, y 1 has no height");
  put("site_elsewhere.geojson",
      R"({"type":"Polygon","coordinates":[[[40,0,1],[43,0,1],[43,3,1],[40,0,1]]]})");
  expect_refused("triangulate points.csv --outline site_elsewhere.geojson -o a.ply",
                 "nowhere near the points");
  expect_refused("triangulate points.csv --snap 1 -o a.ply", "--snap is for lines");
  expect_refused("triangulate points.csv --split-crossings -o a.ply",
                 "--split-crossings is for lines");
  expect_refused("triangulate points.csv --max-edge -1 -o a.ply", "--max-edge must be a length");
  expect_refused("triangulate - --breaklines - -o a.ply", "cannot both be standard input");
}

/// Two squares that touch at row 0: around it there is a vertex for each.
TEST_F(ConstraintsCommand, lists_both_sides_of_a_place_where_an_outline_touches_itself) {
  put("touch.csv",
      "x,y,z\n1,1,0\n0,0,1\n1,0,2\n0,1,3\n2,2,4\n1,2,5\n2,1,6\n0.4,0.5,1\n1.5,1.4,2\n");
  put("touch.geojson", R"({"type":"MultiPolygon","coordinates":[[[[0,0],[1,0],[1,1],[0,1],[0,0]]],)"
                       R"([[[1,1],[2,1],[2,2],[1,2],[1,1]]]]})");
  const auto listed = [&](const std::string& what) {
    return run(what + " touch.csv -k 0 --outline touch.geojson -o list.csv && cat list.csv").out;
  };
  EXPECT_TRUE(
      listed("triangles")
          .ends_with(
              "order\n0,2,7,0\n0,3,7,0\n0,5,8,0\n0,6,8,0\n1,2,7,0\n1,3,7,0\n4,5,8,0\n4,6,8,0\n"));
  EXPECT_NE(listed("edges").find("order\n0,2,0\n0,3,0\n0,5,0\n0,6,0\n0,7,0\n0,8,0\n1,2,0\n"),
            std::string::npos);
}

TEST_F(ConstraintsCommand, lists_every_class) {
  const auto listed = [&](const std::string& what) {
    const Outcome outcome =
        run(what + " --breaklines road.geojson -o list.csv && cat list.csv && rm list.csv");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out.substr(outcome.out.find("order\n"));
  };
  EXPECT_EQ(listed("edges points.csv -k 0 --class kod"),
            listed("edges points.csv --class delaunay"));
  EXPECT_EQ(listed("triangles points.csv -k 0 --class kod"),
            listed("triangles points.csv -k 0 --class valid"));
  EXPECT_GT(listed("edges points.csv -k 2 --class kod").size(),
            listed("edges points.csv -k 2 --class useful").size());
  EXPECT_GT(listed("triangles points.csv -k 2 --class kod").size(),
            listed("triangles points.csv -k 2 --class valid").size());
}

}  // namespace
}  // namespace hodt::test
