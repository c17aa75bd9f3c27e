# hodt as others get it: installed, inside another project, and without what it can do without.
set(consumer ${CMAKE_CURRENT_LIST_DIR})
set(scratch ${PROJECT_BINARY_DIR}/consumer)
set(prefix ${scratch}/prefix)
set(same_tools -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
               -DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER})
set(flags "${CMAKE_CXX_FLAGS}")
if(HODT_SANITIZE)
  string(APPEND flags " -fsanitize=${HODT_SANITIZE}")
endif()

# Configures a project and builds one of its targets, which RUN starts.
function(hodt_build_test name source target)
  cmake_parse_arguments(PARSE_ARGV 3 arg "" "" "OPTIONS;RUN")
  add_test(NAME package.${name}
           COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test ${source} ${scratch}/${name}
                   --build-generator ${CMAKE_GENERATOR} --build-target ${target} --build-noclean
                   --build-options --fresh ${same_tools} "-DCMAKE_CXX_FLAGS=${flags}" ${arg_OPTIONS}
                   --test-command ${arg_RUN})
endfunction()

# Configures a project and looks for a line in what CMake says.
function(hodt_configure_test name source says)
  add_test(NAME package.${name}
           COMMAND ${CMAKE_COMMAND} -S ${source} -B ${scratch}/${name} --fresh
                   -G ${CMAKE_GENERATOR} ${same_tools} ${ARGN})
  set_tests_properties(package.${name} PROPERTIES PASS_REGULAR_EXPRESSION "${says}")
endfunction()

# Installed somewhere and then moved, as packages are.
add_test(NAME package.install COMMAND ${consumer}/install.sh ${PROJECT_BINARY_DIR} ${prefix})
set_tests_properties(package.install PROPERTIES FIXTURES_SETUP installed)
add_test(NAME package.runtime COMMAND ${consumer}/runtime.sh ${PROJECT_BINARY_DIR} ${scratch}/runtime)
set(installed -DCMAKE_PREFIX_PATH=${prefix})
hodt_build_test(find_package ${consumer} terrain RUN terrain mesh.ply
                OPTIONS ${installed} -DCMAKE_DISABLE_FIND_PACKAGE_nlohmann_json=ON)
hodt_build_test(component ${consumer} delaunay RUN delaunay
                OPTIONS ${installed} -DHODT_COMPONENTS=delaunay
                        -DCMAKE_DISABLE_FIND_PACKAGE_ZLIB=ON -DCMAKE_DISABLE_FIND_PACKAGE_PkgConfig=ON)
hodt_build_test(examples ${PROJECT_SOURCE_DIR}/examples hodt_example_researcher
                OPTIONS ${installed} RUN example_researcher ${PROJECT_SOURCE_DIR}/data/jacksboro.csv)
hodt_configure_test(unknown_component ${consumer} "no component \"shading\".[ \n]+It has: base, geometry,"
                    ${installed} "-DHODT_COMPONENTS=io\;shading")
hodt_configure_test(other_version ${consumer} "requested[ \n]+version \"0.2\"" ${installed} -DHODT_WANTED=0.2)
separate_arguments(flags)
add_test(NAME package.pkg_config
         COMMAND ${consumer}/pkg_config.sh ${prefix}/${CMAKE_INSTALL_LIBDIR}/pkgconfig
                 ${CMAKE_CXX_COMPILER} ${flags})
set_tests_properties(package.find_package package.component package.examples package.pkg_config
                     package.unknown_component package.other_version
                     PROPERTIES FIXTURES_REQUIRED installed)

# One component is enough to build: the others are compiled the same way.
hodt_build_test(add_subdirectory ${consumer} delaunay
                OPTIONS -DHODT_SOURCE=${PROJECT_SOURCE_DIR} RUN delaunay)

set(without_programs -DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON -DCMAKE_DISABLE_FIND_PACKAGE_GTest=ON)
hodt_configure_test(library_alone ${PROJECT_SOURCE_DIR} "Generating done" ${without_programs}
                    -DHODT_BUILD_COMMAND=OFF)
hodt_configure_test(without_io ${PROJECT_SOURCE_DIR} "Generating done" ${without_programs}
                    -DHODT_BUILD_IO=OFF -DCMAKE_DISABLE_FIND_PACKAGE_nlohmann_json=ON
                    -DCMAKE_DISABLE_FIND_PACKAGE_ZLIB=ON)
hodt_configure_test(tests_left_out ${PROJECT_SOURCE_DIR} "tests are left out: they need GTest.*Generating done"
                    -DCMAKE_DISABLE_FIND_PACKAGE_GTest=ON)
hodt_configure_test(tests_asked_for ${PROJECT_SOURCE_DIR} "HODT_BUILD_TESTS is ON, but the tests need GTest"
                    -DCMAKE_DISABLE_FIND_PACKAGE_GTest=ON -DHODT_BUILD_TESTS=ON)
add_test(NAME package.presets COMMAND ${consumer}/presets.sh ${PROJECT_SOURCE_DIR} ${scratch}/presets)
hodt_configure_test(without_gdal ${PROJECT_SOURCE_DIR} "formats that need GDAL are left out"
                    ${without_programs} -DHODT_BUILD_COMMAND=OFF -DCMAKE_DISABLE_FIND_PACKAGE_GDAL=ON)
