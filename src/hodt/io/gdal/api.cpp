#include "hodt/io/gdal/api.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/formats.h"
#include "hodt/io/shared_library.h"

namespace hodt {

namespace {

/// Debian's package of the library alone has its number: libgdal32 holds libgdal.so.32.
std::string package() {
  const std::string name = HODT_GDAL_SONAME;
  return "libgdal" + name.substr(name.rfind('.') + 1);
}

[[noreturn]] void refuse(const std::string& why) {
  throw ParameterError(
      fmt::format("this format needs GDAL's library, which cannot be loaded ({}); install it (on "
                  "Debian: apt install {})",
                  why, package()));
}

void CPL_STDCALL ignore(CPLErr, CPLErrorNum, const char*) {}

GdalFunctions load() {
  const SharedLibrary library({HODT_GDAL_SONAME, HODT_GDAL_LIBRARY}, refuse);
  GdalFunctions functions{};
#define HODT_LOAD(name) library.find(#name, functions.name);
  HODT_GDAL_FUNCTIONS(HODT_LOAD)
#undef HODT_LOAD
  functions.CPLPushErrorHandlerEx(ignore, nullptr);  // a plug-in's that cannot be loaded
  functions.GDALAllRegister();
  functions.CPLSetConfigOption("AAIGRID_DATATYPE", "Float64");   // ASCII grids are read as they are
  functions.CPLSetConfigOption("GTIFF_REPORT_COMPD_CS", "YES");  // heights have a system, too
  functions.CPLPopErrorHandler();
  return functions;
}

void CPL_STDCALL keep_first(CPLErr kind, CPLErrorNum, const char* message) {
  auto& first = *static_cast<std::string*>(gdal().CPLGetErrorHandlerUserData());
  if (kind < CE_Failure || !first.empty()) return;
  first = message;
  std::replace(first.begin(), first.end(), '\n', ' ');
}

}  // namespace

const GdalFunctions& gdal() {
  static const GdalFunctions functions = load();
  return functions;
}

bool has_gdal() {
  return true;
}

GdalErrors::GdalErrors() {
  gdal().CPLPushErrorHandlerEx(keep_first, &first_);
}

GdalErrors::~GdalErrors() {
  gdal().CPLPopErrorHandler();
}

std::string GdalErrors::take() {
  return std::exchange(first_, {});
}

}  // namespace hodt
