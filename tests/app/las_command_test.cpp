// LAS and LAZ for every subcommand that reads points.
#include <filesystem>
#include <string>

#include "command_fixture.h"
#include "point_commands.h"

namespace hodt::test {
namespace {

class LasCommand : public CommandTest {
 protected:
  static std::string cloud(const std::string& name) {
    return (std::filesystem::path(HODT_TEST_FILES) / ".." / "io" / "las" / name).string();
  }
};

TEST_F(LasCommand, says_which_points_were_taken) {
  for (const char* command : kPointCommands) {
    SCOPED_TRACE(command);
    const auto said = [&](const std::string& input) {
      const Outcome outcome = run(with(command, input));
      EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
      EXPECT_EQ(outcome.err, "");
      return outcome.out;
    };
    const std::string ground = said(cloud("7.laz"));
    EXPECT_NE(ground.find("X, Y, Z of class 2 (ground): "), std::string::npos) << ground;
    EXPECT_NE(ground.find(" of 200 points, "), std::string::npos) << ground;
    const std::string last = said(cloud("1.las") + " --las-class all --las-return last");
    EXPECT_NE(last.find("X, Y, Z of all classes, last returns: "), std::string::npos) << last;
  }
}

TEST_F(LasCommand, says_it_in_the_json) {
  const Outcome outcome = run("info " + cloud("1.laz") + " --las-class 2,9 --json -");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  const Json las = json["columns"]["las"];
  EXPECT_EQ(las["points"], 200);
  EXPECT_EQ(las["taken"], json["points"]);
  EXPECT_EQ(las["returns"], "all");
  EXPECT_EQ(las["all_classes"], false);
  int taken = 0;
  for (const Json& one : las["classes"]) {
    const int number = one["class"];
    EXPECT_EQ(one["taken"], number == 2 || number == 9 ? one["points"] : Json(0));
    taken += int(one["taken"]);
  }
  EXPECT_EQ(taken, las["taken"]);
  EXPECT_EQ(taken + int(las["withheld"]) + int(las["of_other_classes"]), 200);
}

TEST_F(LasCommand, refuses_choices_of_other_files) {
  put("points.csv", "x,y,z\n0,0,1\n1,0,2\n0,1,3\n");
  put("mesh.obj", "v 0 0 4\nv 1 0 2\nv 0 1 0\nf 1 2 3\n");
  for (const char* command : kPointCommands) {
    SCOPED_TRACE(command);
    expect_refused(with(command, "points.csv --las-class 2"), "points.csv is a table");
    expect_refused(with(command, "points.csv --las-return last"), "for LAS and LAZ files");
    expect_refused(with(command, cloud("1.laz") + " --columns x=1,y=2"),
                   "--columns is for tables of points");
    expect_refused(with(command, "points.csv --las-class ground"), "--las-class takes numbers");
    expect_refused(with(command, cloud("1.laz") + " --las-return 2"), "--las-return takes");
    expect_refused(with(command, cloud("1.laz") + " --las-class 77"), "none of its 200 points");
  }
  expect_refused("triangulate mesh.obj -o out.obj --las-class 2", "mesh.obj is a mesh");
}

}  // namespace
}  // namespace hodt::test
