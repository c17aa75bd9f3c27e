// What stands for the room io/gdal if GDAL was not there when hodt was built: each of its functions
// says so.
// Tested by tests/io/gdal_test.cpp.
#include "hodt/base/error.h"
#include "hodt/io/formats.h"

namespace hodt {

namespace {

[[noreturn, maybe_unused]] void refuse() {
  throw ParameterError(
      "this format needs GDAL, without which this hodt was built; install it (on Debian: apt "
      "install "
      "libgdal-dev) and build hodt again");
}

}  // namespace

bool has_gdal() {
  return false;
}

}  // namespace hodt
