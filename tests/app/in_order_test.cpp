// hodt triangulate with objectives in order.
#include <string>

#include "command_fixture.h"
#include <gtest/gtest.h>

namespace hodt {
namespace {

using test::Json;
using test::Outcome;

class InOrderCommand : public test::CommandTest {
 protected:
  void sample() { ASSERT_EQ(run("sample valley -n 2000 -o points.csv").exit_code, 0); }
};

TEST_F(InOrderCommand, tells_each_value) {
  sample();
  const Outcome outcome =
      run("triangulate points.csv -o mesh.ply -k 4 --objective "
          "min-local-minima,min-sum-abn,min-sum-length --json report.json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* name : {"min-local-minima", "min-sum-abn", "min-sum-length"})
    EXPECT_NE(outcome.out.find(name), std::string::npos) << outcome.out;
  const Json report = json("report.json");
  EXPECT_EQ(report["objective"], "min-local-minima");
  ASSERT_EQ(report["then"].size(), 2u);
  EXPECT_EQ(report["then"][0]["objective"], "min-sum-abn");
  EXPECT_EQ(report["then"][1]["objective"], "min-sum-length");
  for (const Json& then : report["then"]) {
    const Json& value = then["value"];
    EXPECT_LE(value["bound"].get<double>(), value["result"].get<double>());
    EXPECT_FALSE(value["bound_in_order"].get<bool>());
    EXPECT_FALSE(value.contains("input"));
  }
  ASSERT_EQ(run("triangulate points.csv -o alone.ply -k 4 --json alone.json").exit_code, 0);
  const Json alone = json("alone.json");
  EXPECT_EQ(report["value"], alone["value"]);
  EXPECT_EQ(alone["then"], Json::array());
  EXPECT_EQ(run("check mesh.ply -k 4 --strict").exit_code, 0);
}

TEST_F(InOrderCommand, terrain_stands_for_a_list_and_its_order) {
  sample();
  const auto mesh = [&](const std::string& options) {
    EXPECT_EQ(run("triangulate points.csv -o mesh.ply " + options).exit_code, 0);
    return test::content_of(directory_ / "mesh.ply");
  };
  EXPECT_EQ(mesh("--objective terrain"), mesh("-k 8 --objective min-local-minima,min-sum-abn"));
  EXPECT_EQ(mesh("--objective terrain -k 2"),
            mesh("--objective min-local-minima,min-sum-abn -k 2"));
  EXPECT_EQ(mesh(""), mesh("-k 4"));
}

TEST_F(InOrderCommand, is_solved_at_order_1) {
  sample();
  ASSERT_EQ(run("triangulate points.csv -o mesh.ply -k 1 --json report.json --objective "
                "min-local-minima,min-sum-abn")
                .exit_code,
            0);
  const Json value = json("report.json")["then"][0]["value"];
  EXPECT_TRUE(value["optimal"].get<bool>());
  EXPECT_TRUE(value["bound_in_order"].get<bool>());
  EXPECT_EQ(value["bound"], value["result"]);
}

TEST_F(InOrderCommand, compares_with_a_mesh) {
  sample();
  ASSERT_EQ(run("triangulate points.csv -o mesh.ply --objective none").exit_code, 0);
  ASSERT_EQ(run("triangulate mesh.ply -o better.ply --json report.json --objective "
                "min-max-angle,min-sum-abn")
                .exit_code,
            0);
  const Json report = json("report.json");
  EXPECT_EQ(report["then"][0]["value"]["input"], report["then"][0]["value"]["delaunay"]);
}

TEST_F(InOrderCommand, refuses_lists_that_cannot_be) {
  sample();
  const std::string start = "triangulate points.csv -o out.ply --objective ";
  expect_refused(start + "min-sum-abn,min-sum-abn", "twice");
  expect_refused(start + "min-sum-abn,none", "none");
  expect_refused(start + "min-sum-abn,beauty", "beauty");
  expect_refused(start + "min-sum-abn,", "unknown objective ''");
  expect_refused(start + "min-sum-abn,min-sum-jnd,min-sum-wabn,min-max-abn", "too many");
  expect_refused(start + "min-local-minima,min-sum-abn --method greedy", "greedy");
  expect_refused(start + "min-sum-abn,min-local-minima --min-pit-depth 1", "first");
}

}  // namespace
}  // namespace hodt
