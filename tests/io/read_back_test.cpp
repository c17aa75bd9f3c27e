// Every mesh format, read back by programs that others wrote: tests/io/read_back.py has what it
// asks of which. HODT_PYTHON names the Python that has them, and HODT_GLTF_VALIDATOR a folder of
// npm's in which gltf-validator is installed. What is missing is skipped.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "sample_tins.h"
#include "temporary_directory.h"
#include <gtest/gtest.h>
#include <sys/wait.h>

#include "hodt/io/formats.h"
#include "hodt/io/tin_file.h"

namespace hodt {
namespace {

using test::TemporaryDirectory;

template <class T>
std::string_view raw(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// The mesh in every format, and as plain numbers.
void write_all(const Tin& tin, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const Format* format : test::mesh_formats())
    write_tin(tin, folder / ("terr\xc3\xa4n 1" + test::first_extension(*format)));
  const auto put = [&](const char* name, std::string_view bytes) {
    std::ofstream(folder / name, std::ios::binary) << bytes;
  };
  put("xy", raw(tin.points.xy));
  put("z", raw(tin.points.z));
  put("triangles", raw(tin.triangles));
  put("order", raw(tin.order));
  put("crs", tin.crs);
}

class ReadBack : public testing::TestWithParam<const char*> {};

TEST_P(ReadBack, FindsWhatWasWritten) {
  if (!has_gdal()) GTEST_SKIP() << "built without GDAL";
  const TemporaryDirectory directory;
  write_all(test::survey(3000), directory / "survey");
  write_all(test::survey(20, test::wkt()), directory / "wkt");
  write_all(test::plain_triangle(), directory / "plain");
  const char* python = std::getenv("HODT_PYTHON");
  const std::string said = (directory / "said").string();
  const int status = std::system(
      (std::string(python ? python : "python3") + " '" HODT_SOURCE_DIR "/tests/io/read_back.py' " +
       GetParam() + " '" + directory.path().string() + "' >'" + said + "' 2>&1 </dev/null")
          .c_str());
  const std::string text = test::content_of(said);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 77) GTEST_SKIP() << text;
  EXPECT_EQ(status, 0) << text;
}

INSTANTIATE_TEST_SUITE_P(By, ReadBack,
                         testing::Values("meshio", "vtk", "netcdf4", "xarray", "plyfile", "trimesh",
                                         "landxml", "gltf", "gdal", "qgis", "qgis_vector"),
                         [](const auto& each) { return std::string(each.param); });

}  // namespace
}  // namespace hodt
