# Debian packages by CPack: hodt, libhodt-dev and python3-hodt, as the system's own are laid out. What
# they are made of beyond what is installed anyway is in packaging/debian.
set(debian ${PROJECT_SOURCE_DIR}/packaging/debian)
set(made ${PROJECT_BINARY_DIR}/packages)
set(packages hodt libhodt-dev python3-hodt)
if(NOT HODT_BUILD_PYTHON)
  if("$CACHE{HODT_BUILD_PYTHON}" STREQUAL "AUTO")
    message(FATAL_ERROR "python3-hodt is built with build/venv, which scripts/python_venv.sh makes; "
                        "-DHODT_BUILD_PYTHON=OFF makes the packages without it")
  endif()
  list(REMOVE_ITEM packages python3-hodt)
endif()
set(component_hodt runtime)
set(component_libhodt-dev development)
set(component_python3-hodt python)

# The changelog says which packages these are.
file(STRINGS ${debian}/changelog first LIMIT_COUNT 1)
if(NOT first MATCHES "^hodt \\(([0-9.]+)-([0-9]+)\\)" OR NOT CMAKE_MATCH_1 STREQUAL PROJECT_VERSION)
  message(FATAL_ERROR "packaging/debian/changelog does not begin with hodt (${PROJECT_VERSION}-REVISION)")
endif()
set(CPACK_DEBIAN_PACKAGE_RELEASE ${CMAKE_MATCH_2})
file(STRINGS ${debian}/changelog signed REGEX "^ -- " LIMIT_COUNT 1)
string(REGEX REPLACE "^ -- (.*>)  .*" "\\1" CPACK_DEBIAN_PACKAGE_MAINTAINER "${signed}")

# The licence's text is the system's. Others' code that is compiled in has theirs with it.
function(hodt_write_copyright package)
  file(READ ${debian}/copyright text)
  foreach(part IN LISTS ARGN)
    string(REGEX REPLACE "=.*" "" name ${part})
    string(REGEX REPLACE ".*=" "" file ${part})
    file(READ ${file} theirs)
    if(file MATCHES "\\.h$") # its first comment
      string(REGEX REPLACE "\\*/.*" "*/\n" theirs "${theirs}")
    endif()
    string(APPEND text "\n\n${name} is compiled in. Its copyright and licence:\n\n${theirs}")
  endforeach()
  file(WRITE ${made}/${package}/copyright "${text}")
endfunction()
set(json "nlohmann JSON=/usr/share/doc/nlohmann-json3-dev/copyright")
set(cli "CLI11=/usr/share/doc/libcli11-dev/copyright")
hodt_write_copyright(hodt ${cli} ${json})
hodt_write_copyright(libhodt-dev ${json})
if(HODT_BUILD_PYTHON)
  file(GLOB nanobind ${nanobind_DIR}/../../nanobind-*.dist-info/licenses/LICENSE)
  set(robin_map ${nanobind_DIR}/../ext/robin_map/include/tsl/robin_map.h)
  hodt_write_copyright(python3-hodt ${cli} ${json} nanobind=${nanobind} robin_map=${robin_map})
endif()

function(hodt_pack file to)
  execute_process(COMMAND gzip -9nc ${file} OUTPUT_FILE ${made}/${package}/${to} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

foreach(package IN LISTS packages)
  set(component ${component_${package}})
  hodt_pack(${debian}/changelog changelog.Debian.gz)
  hodt_pack(${PROJECT_SOURCE_DIR}/CHANGELOG.md changelog.gz)
  install(FILES ${made}/${package}/copyright ${made}/${package}/changelog.Debian.gz ${made}/${package}/changelog.gz
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component})
  install(FILES ${debian}/${package}.lintian-overrides RENAME ${package}
          DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides COMPONENT ${component})
endforeach()

# As debhelper does: pages are packed, and the compiler's name is no part of what it made.
install(CODE "file(GLOB pages \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_MANDIR}/man1/*.1\")
              execute_process(COMMAND gzip -9nf \${pages} COMMAND_ERROR_IS_FATAL ANY)" COMPONENT runtime)
install(CODE "file(GLOB libraries \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/libhodt_*.a\")
              execute_process(COMMAND strip --strip-debug --remove-section=.comment --enable-deterministic-archives
                                      \${libraries} COMMAND_ERROR_IS_FATAL ANY)" COMPONENT development)
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libhodt-dev COMPONENT development)
function(hodt_forget_compiler file component)
  install(CODE "execute_process(COMMAND strip --remove-section=.comment \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${file}\"
                                COMMAND_ERROR_IS_FATAL ANY)" COMPONENT ${component})
endfunction()
hodt_forget_compiler(${CMAKE_INSTALL_BINDIR}/$<TARGET_FILE_NAME:hodt_program> runtime)
if(HODT_BUILD_PYTHON)
  set(modules lib/python3/dist-packages)
  install(TARGETS hodt_python LIBRARY DESTINATION ${modules}/hodt COMPONENT python)
  hodt_forget_compiler(${modules}/hodt/$<TARGET_FILE_NAME:hodt_python> python)
  install(DIRECTORY python/hodt DESTINATION ${modules} COMPONENT python
          FILES_MATCHING PATTERN "*.py" PATTERN "*.pyi" PATTERN "py.typed" PATTERN "__pycache__" EXCLUDE)
  configure_file(${debian}/METADATA.in ${made}/python3-hodt/METADATA @ONLY)
  install(FILES ${made}/python3-hodt/METADATA DESTINATION ${modules}/hodt-${PROJECT_VERSION}.dist-info
          COMPONENT python)
endif()

# Which package has a library is what the system says.
function(hodt_package_of library result)
  file(REAL_PATH ${library} library)
  execute_process(COMMAND dpkg-query -S ${library} OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX REPLACE ":.*" "" said "${said}")
  set(${result} ${said} PARENT_SCOPE)
endfunction()
hodt_package_of(${GDAL_LIBRARY} gdal) # loaded when it is needed, so dpkg-shlibdeps does not see it

set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each has its own
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
                                                WORLD_READ WORLD_EXECUTE)

set(CPACK_COMPONENTS_ALL "")
foreach(package IN LISTS packages)
  set(component ${component_${package}})
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  string(TOUPPER ${component} COMPONENT)
  file(READ ${debian}/${package}.description CPACK_DEBIAN_${COMPONENT}_DESCRIPTION)
  set(CPACK_DEBIAN_${COMPONENT}_PACKAGE_NAME ${package})
endforeach()

set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION science)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "${gdal}, librsvg2-2") # loaded likewise, for pictures as PNG

# hodt.pc and hodtConfig.cmake ask for these.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libtbb-dev, libfmt-dev, coinor-libclp-dev, zlib1g-dev, libsqlite3-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS "pkg-config")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "cmake, ${gdal}")

# The extension is for this version of Python.
execute_process(COMMAND ${Python_EXECUTABLE} -c "import sys; print(sys.version_info.minor)"
                OUTPUT_VARIABLE minor OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
math(EXPR next "${minor} + 1")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= 3.${minor}~), python3 (<< 3.${next}), python3-numpy (>= 1:1.24)")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "${gdal}, librsvg2-2")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS
    "hodt, python3-matplotlib, python3-meshio, python3-geopandas, python3-shapely, python3-xarray")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${debian}/python3-hodt/postinst;${debian}/python3-hodt/prerm")

include(CPack)
