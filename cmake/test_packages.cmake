# What the tests are built with. HODT_BUILD_TESTS becomes ON or OFF here: AUTO is ON if all of it is
# there, and the command, which many tests run.
if(NOT HODT_BUILD_TESTS)
  return()
endif()

find_package(GTest QUIET)
find_package(rapidcheck QUIET)
find_library(HODT_GMP gmp)
find_library(HODT_GMPXX gmpxx)
find_path(HODT_CGAL CGAL/version.h)

set(missing "")
foreach(name IN ITEMS GTest rapidcheck GMP GMPXX CGAL)
  if(NOT ${name}_FOUND AND NOT HODT_${name})
    list(APPEND missing ${name})
  endif()
endforeach()
if(NOT HODT_BUILD_COMMAND)
  list(APPEND missing HODT_BUILD_COMMAND)
endif()
list(JOIN missing ", " missing)

if(NOT missing)
  set(HODT_BUILD_TESTS ON)
elseif(HODT_BUILD_TESTS STREQUAL "AUTO")
  message(STATUS "The tests are left out: they need ${missing} (scripts/dependencies.sh test installs packages)")
  set(HODT_BUILD_TESTS OFF)
else()
  message(FATAL_ERROR "HODT_BUILD_TESTS is ${HODT_BUILD_TESTS}, but the tests need ${missing}. "
                      "scripts/dependencies.sh test installs packages; "
                      "-DHODT_BUILD_TESTS=OFF leaves the tests out.")
endif()
