// Which columns a subcommand takes for x, y and z, and that it says so. Covers points_input.
#include <string>

#include "command_fixture.h"
#include "point_commands.h"

namespace hodt::test {
namespace {

/// Point number, northing, easting, height, code: nothing tells them apart.
const char* const kSurvey =
    "1,200,600.5,4,GND\n2,200,610,3,GND\n3,210,600,2,GND\n4,211,611,1,GND\n5,205,604,7,GND\n";

class ColumnsCommand : public CommandTest {};

TEST_F(ColumnsCommand, are_chosen_and_told_alike_everywhere) {
  put("survey.txt", kSurvey);
  for (const char* command : kPointCommands) {
    SCOPED_TRACE(command);
    expect_refused(with(command, "survey.txt"), "--columns x=2,y=3,z=4");
    expect_refused(with(command, "survey.txt --columns x=3,y=9"), "there is no column '9'");
    expect_refused(with(command, "survey.txt --columns 3,2,4"), "--columns must name");
    const Outcome outcome = run(with(command, "survey.txt --columns x=3,y=2,z=4"));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out.find("x = column 3, y = column 2, z = column 4"), std::string::npos)
        << outcome.out;
  }
  for (const char* command : {"info", "triangulate", "edges", "triangles", "voronoi", "compare"})
    EXPECT_NE(run(std::string(command) + " --help").out.find("the first is 1"), std::string::npos);
}

TEST_F(ColumnsCommand, are_in_the_json) {
  put("survey.csv", "Nr;Nord;Ost;H\xF6he\n1;200;600,5;4\n2;200;610;3\n3;210;600;2\n4;211;611;1\n");
  for (const char* command :
       {"info % --json -", "triangulate % -o out.obj --json -", "compare % --orders 1 --json -"}) {
    const Outcome outcome = run(with(command, "survey.csv"));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json columns = Json::parse(outcome.out)["columns"];
    EXPECT_EQ(columns["x"]["number"], 3);
    EXPECT_EQ(columns["x"]["name"], "Ost");
    EXPECT_EQ(columns["y"]["number"], 2);
    EXPECT_EQ(columns["z"]["name"], "H\xC3\xB6he");
  }
  put("flat.xyz", "0 0\n1 0\n0 1\n");
  const Json columns = Json::parse(run("info flat.xyz --json -").out)["columns"];
  EXPECT_TRUE(columns["x"]["name"].is_null());
  EXPECT_TRUE(columns["z"].is_null());
  EXPECT_NE(run("info flat.xyz").out.find("x = column 1, y = column 2, no z"), std::string::npos);
}

TEST_F(ColumnsCommand, take_coordinates_from_where_they_are) {
  put("survey.txt", kSurvey);
  ASSERT_EQ(run("triangulate survey.txt --columns x=3,y=2,z=4 -o out.obj").exit_code, 0);
  EXPECT_NE(content_of(directory_ / "out.obj").find("v 600.5 200 4\nv 610 200 3\n"),
            std::string::npos);
}

TEST_F(ColumnsCommand, that_count_are_a_hint) {
  put("counts.csv", "1,5,5\n2,7,5\n3,6,6\n4,9,7\n");
  const Outcome outcome = run("triangulate counts.csv -o out.obj");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.err.find("hodt: warning: counts.csv: x counts 1, 2, 3"), std::string::npos)
      << outcome.err;
  const Outcome info = run("info counts.csv");
  EXPECT_EQ(info.err, "");
  EXPECT_NE(info.out.find("hint    x counts 1, 2, 3"), std::string::npos) << info.out;
}

TEST_F(ColumnsCommand, heights_that_mean_none_are_a_warning) {
  std::string rows;
  for (int i = 0; i < 400; ++i)
    rows += std::to_string(i % 20) + " " + std::to_string(i / 20) + " " +
            (i % 7 ? std::to_string(i % 11) : "-9999") + "\n";
  put("raster.xyz", rows);
  EXPECT_NE(run("triangulate raster.xyz -o out.obj").err.find("58 of 400 heights are -9999"),
            std::string::npos);
}

TEST_F(ColumnsCommand, of_the_truth_are_chosen_apart) {
  ASSERT_EQ(run("sample jacksboro -n 200 -o points.csv").exit_code, 0);
  put("truth.txt", "7 736000 4069000 500 1\n9 737000.5 4070000 510 1\n");
  const std::string compare = "compare points.csv --orders 1 --truth truth.txt";
  expect_refused(compare, "truth.txt");
  expect_refused(compare + " --truth-columns 9", "--truth-columns must name");
  EXPECT_EQ(run(compare + " --truth-columns x=2,y=3,z=4").exit_code, 0);
}

TEST_F(ColumnsCommand, other_formats_are_called_by_name) {
  put("grid.txt", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n3 4\n");
  put("mesh.ply", "ply\nformat ascii 1.0\nelement vertex 0\nend_header\n");
  for (const char* command : kPointCommands) {
    expect_refused(with(command, "grid.txt"), "grid.txt is a raster (ESRI ASCII grid)");
    // One that can be improved is no error, but this one holds nothing.
    const std::string_view name = command;
    const bool takes_meshes = name.starts_with("triangulate") || name.starts_with("compare");
    expect_refused(with(command, "mesh.ply"), takes_meshes ? "mesh.ply has vertices without x and y"
                                                           : "mesh.ply is a mesh (PLY)");
  }
}

}  // namespace
}  // namespace hodt::test
