#include "hodt/io/gdal/api.h"

#include <algorithm>
#include <utility>

#include <dlfcn.h>
#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/formats.h"

namespace hodt {

namespace {

[[noreturn]] void refuse(const std::string& why) {
  throw ParameterError(
      fmt::format("this format needs GDAL's library, which cannot be loaded ({}); install it (on "
                  "Debian: apt install libgdal-dev)",
                  why));
}

std::string loading_error() {
  const char* const error = dlerror();
  return error ? error : "unknown error";
}

void* load_library() {
  for (const char* const name : {HODT_GDAL_SONAME, HODT_GDAL_LIBRARY})
    if (void* const library = dlopen(name, RTLD_LAZY | RTLD_LOCAL)) return library;
  refuse(loading_error());
}

template <class F>
void load_function(void* library, const char* name, F& function) {
  function = reinterpret_cast<F>(dlsym(library, name));
  if (!function) refuse(loading_error());
}

void CPL_STDCALL ignore(CPLErr, CPLErrorNum, const char*) {}

GdalFunctions load() {
  void* const library = load_library();
  GdalFunctions functions{};
#define HODT_LOAD(name) load_function(library, #name, functions.name);
  HODT_GDAL_FUNCTIONS(HODT_LOAD)
#undef HODT_LOAD
  functions.CPLPushErrorHandlerEx(ignore, nullptr);  // a plug-in's that cannot be loaded
  functions.GDALAllRegister();
  functions.CPLSetConfigOption("AAIGRID_DATATYPE", "Float64");  // ASCII grids are read as they are
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
