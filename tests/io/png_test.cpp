#include "hodt/io/png.h"

#include <cstdlib>
#include <fstream>
#include <string>

#include "ogr.h"
#include "temporary_directory.h"
#include <gtest/gtest.h>

namespace hodt {
namespace {

TEST(Png, IsReadByOthersAsItWas) {
  if (!test::has_ogr()) GTEST_SKIP() << "needs the programs of Debian's package gdal-bin";
  const Image image{3, 2, {{1, 2, 3}, {250, 128, 0}}, {0, 1, 0, 1, 1, 0}};
  const test::TemporaryDirectory directory;
  const std::string file = (directory / "image.png").string();
  std::ofstream(file, std::ios::binary) << png_of(image);
  const std::string text = (directory / "image.xyz").string();
  std::string seen;
  for (const char* band : {"1", "2", "3"}) {
    const std::string one = "gdal_translate -q -expand rgb -of VRT '" + file + "' '" +
                            (directory / "rgb.vrt").string() +
                            "' && gdal_translate -q -of XYZ -b " + band + " '" +
                            (directory / "rgb.vrt").string() + "' '" + text + "'";
    ASSERT_EQ(std::system(one.c_str()), 0);
    std::ifstream lines(text);
    for (double x, y, value; lines >> x >> y >> value;) seen += std::to_string(int(value)) + " ";
  }
  EXPECT_EQ(seen, "1 250 1 250 250 1 2 128 2 128 128 2 3 0 3 0 0 3 ");
}

}  // namespace
}  // namespace hodt
