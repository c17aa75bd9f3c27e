#include <gtest/gtest.h>

#include "hodt/io/formats.h"

namespace hodt {
namespace {

TEST(Gdal, IsThereOrNot) {
  EXPECT_EQ(has_gdal(), has_gdal());
}

}  // namespace
}  // namespace hodt
