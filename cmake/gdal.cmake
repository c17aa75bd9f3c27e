# Whether io has its formats that need GDAL. Only GDAL's headers are needed to build them: its library
# is loaded when such a file is opened (src/hodt/io/gdal/api.h), because loading it takes longer than most
# of what hodt does, and so nobody who has hodt needs GDAL but for these formats.
#
# Sets HODT_GDAL (ON or OFF), HODT_GDAL_INCLUDE, HODT_GDAL_DEFINITIONS and HODT_GDAL_LEAVE_OUT.
set(HODT_GDAL OFF)
if(HODT_WITH_GDAL)
  find_package(GDAL QUIET MODULE)
  if(GDAL_FOUND AND GDAL_VERSION VERSION_GREATER_EQUAL 3.4)
    set(HODT_GDAL ON)
  elseif(NOT HODT_WITH_GDAL STREQUAL "AUTO")
    message(FATAL_ERROR "HODT_WITH_GDAL is ${HODT_WITH_GDAL}, but there is no GDAL 3.4 or later. Debian's package "
                        "is libgdal-dev; -DHODT_WITH_GDAL=OFF does without.")
  else()
    message(STATUS "The formats that need GDAL are left out: it is not there (Debian's package is libgdal-dev)")
  endif()
endif()

set(HODT_GDAL_INCLUDE "")
set(HODT_GDAL_DEFINITIONS "")
if(HODT_GDAL)
  set(HODT_GDAL_LEAVE_OUT "/io/no_gdal\\.cpp$")
  get_target_property(HODT_GDAL_INCLUDE GDAL::GDAL INTERFACE_INCLUDE_DIRECTORIES)
  # libgdal.so.32.3.6.2 is loaded as libgdal.so.32, wherever the system has it, or from here.
  file(REAL_PATH "${GDAL_LIBRARY}" library)
  get_filename_component(soname "${library}" NAME)
  string(REGEX REPLACE "^(.*\\.so\\.[0-9]+).*" "\\1" soname "${soname}")
  set(HODT_GDAL_DEFINITIONS HODT_GDAL_SONAME="${soname}" HODT_GDAL_LIBRARY="${library}")
else()
  set(HODT_GDAL_LEAVE_OUT "/io/gdal/")
endif()
