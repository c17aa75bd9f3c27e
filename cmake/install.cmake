# What `cmake --install` puts where. Component runtime: the command, its pages for man and its
# completions; development: the library.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/hodt)
get_property(components GLOBAL PROPERTY HODT_COMPONENTS)

foreach(component IN LISTS components)
  install(TARGETS hodt_${component} EXPORT hodt
          ARCHIVE COMPONENT development
          FILE_SET HEADERS COMPONENT development)
endforeach()
install(EXPORT hodt NAMESPACE hodt:: DESTINATION ${package_dir} FILE hodtTargets.cmake
        COMPONENT development)

set(made ${PROJECT_BINARY_DIR}/package)
configure_file(cmake/hodtConfig.cmake.in ${made}/hodtConfig.cmake @ONLY)
write_basic_package_version_file(${made}/hodtConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${made}/hodtConfig.cmake ${made}/hodtConfigVersion.cmake DESTINATION ${package_dir}
        COMPONENT development)

# hodt.pc finds the prefix from where it lies, so that the installation can be moved.
file(RELATIVE_PATH to_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" to_prefix ${to_prefix})
file(RELATIVE_PATH to_libraries ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_LIBDIR})
file(RELATIVE_PATH to_headers ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_INCLUDEDIR})
set(libraries ${components}) # a library stands before those that it needs
list(REVERSE libraries)
list(TRANSFORM libraries PREPEND "-lhodt_")
list(JOIN libraries " " libraries)
set(needed "tbb fmt clp")
if("io" IN_LIST components)
  string(APPEND needed " zlib sqlite3")
endif()
configure_file(cmake/hodt.pc.in ${made}/hodt.pc @ONLY)
install(FILES ${made}/hodt.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)

if(NOT HODT_DEBIAN) # Debian's packages have their own way to say it
  install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development)
endif()
if(HODT_BUILD_COMMAND)
  set(zsh_folder $<IF:$<BOOL:${HODT_DEBIAN}>,vendor-completions,site-functions>)
  # Finds libraries outside the system's folders, such as those of a home directory.
  set_target_properties(hodt_program PROPERTIES INSTALL_RPATH_USE_LINK_PATH ON)
  install(TARGETS hodt_program RUNTIME COMPONENT runtime)
  install(DIRECTORY ${HODT_MANUAL}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT runtime)
  install(FILES ${HODT_MANUAL}/bash/hodt DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
          COMPONENT runtime)
  install(FILES ${HODT_MANUAL}/zsh/_hodt DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/${zsh_folder} COMPONENT runtime)
  install(FILES ${HODT_MANUAL}/fish/hodt.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
          COMPONENT runtime)
  if(NOT HODT_DEBIAN)
    install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
  endif()
endif()
