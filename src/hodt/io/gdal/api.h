// GDAL's functions that hodt uses, from a library that is loaded when the first of them is needed.
//
// To load GDAL with the program would take longer than most of what hodt does.
// Tested by tests/io/gdal_test.cpp.
#pragma once

#include <string>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_string.h>
#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

namespace hodt {

/// The functions by their names: gdal().OGR_L_GetName(layer). What else is needed gets a line here.
/// What the library allocates, VSIFree frees.
#define HODT_GDAL_FUNCTIONS(FUNCTION)  \
  FUNCTION(CPLGetErrorHandlerUserData) \
  FUNCTION(CPLPopErrorHandler)         \
  FUNCTION(CPLPushErrorHandlerEx)      \
  FUNCTION(CPLSetConfigOption)         \
  FUNCTION(CSLDestroy)                 \
  FUNCTION(CSLSetNameValue)            \
  FUNCTION(GDALAllRegister)            \
  FUNCTION(GDALClose)                  \
  FUNCTION(GDALCreate)                 \
  FUNCTION(GDALDatasetCreateLayer)     \
  FUNCTION(GDALGetDriverByName)        \
  FUNCTION(GDALOpenEx)                 \
  FUNCTION(OGR_F_Create)               \
  FUNCTION(OGR_F_Destroy)              \
  FUNCTION(OGR_F_SetFieldDouble)       \
  FUNCTION(OGR_F_SetFieldInteger64)    \
  FUNCTION(OGR_F_SetFieldNull)         \
  FUNCTION(OGR_F_SetFieldString)       \
  FUNCTION(OGR_F_SetGeometryDirectly)  \
  FUNCTION(OGR_Fld_Create)             \
  FUNCTION(OGR_Fld_Destroy)            \
  FUNCTION(OGR_G_CreateFromWkb)        \
  FUNCTION(OGR_L_CreateFeature)        \
  FUNCTION(OGR_L_CreateField)          \
  FUNCTION(OGR_L_GetLayerDefn)         \
  FUNCTION(OSRExportToWktEx)           \
  FUNCTION(OSRNewSpatialReference)     \
  FUNCTION(OSRRelease)                 \
  FUNCTION(OSRSetAxisMappingStrategy)  \
  FUNCTION(OSRSetFromUserInput)        \
  FUNCTION(OSRSetLocalCS)              \
  FUNCTION(VSIFree)

struct GdalFunctions {
#define HODT_DECLARE(name) decltype(&::name) name;
  HODT_GDAL_FUNCTIONS(HODT_DECLARE)
#undef HODT_DECLARE
};

/// Loads the library, and registers its formats, on the first call. Throws ParameterError if it is
/// not there, saying how to get it.
const GdalFunctions& gdal();

/// While one lives, GDAL prints nothing, and its first error is kept for ours.
class GdalErrors {
 public:
  GdalErrors();
  ~GdalErrors();
  GdalErrors(const GdalErrors&) = delete;
  GdalErrors& operator=(const GdalErrors&) = delete;

  /// The first error since the last call, in a line; empty if there was none.
  std::string take();

 private:
  std::string first_;
};

}  // namespace hodt
