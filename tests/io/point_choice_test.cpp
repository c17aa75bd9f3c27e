#include "hodt/io/point_choice.h"

#include <string>

#include "temporary_directory.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"

namespace hodt {
namespace {

TEST(PointChoice, IsForFilesOfItsKind) {
  const PointChoice choices[] = {{.columns = {{"x", "y", "z"}}},
                                 {.layer = {.vertices = true}},
                                 {.raster = {.band = 0, .stride = 2}}};
  const PointKind kinds[] = {PointKind::table, PointKind::features, PointKind::raster};
  for (int chosen = 0; chosen < 3; ++chosen)
    for (int kind = 0; kind < 3; ++kind) {
      const auto check = [&] { check_choice(choices[chosen], kinds[kind], "a.dat"); };
      if (chosen == kind)
        EXPECT_NO_THROW(check());
      else
        EXPECT_NE(test::message_of<ParameterError>(check).find("and a.dat is a"),
                  std::string::npos);
    }
  for (const PointKind kind : kinds) EXPECT_NO_THROW(check_choice({}, kind, "a"));
}

}  // namespace
}  // namespace hodt
