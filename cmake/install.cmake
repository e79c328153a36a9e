# What is installed: the component library, which needs nothing but the headers of CGAL and Eigen, and where they are built
# the components command and documentation.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/CGAL_ext)
install(DIRECTORY include/CGAL_ext DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library)
install(TARGETS CGAL_ext EXPORT CGAL_extTargets)
install(EXPORT CGAL_extTargets NAMESPACE CGAL_ext:: DESTINATION ${package_dir} COMPONENT library)
configure_package_config_file(cmake/CGAL_extConfig.cmake.in ${PROJECT_BINARY_DIR}/CGAL_extConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/CGAL_extConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/CGAL_extConfig.cmake ${PROJECT_BINARY_DIR}/CGAL_extConfigVersion.cmake
              cmake/CGAL_ext_dependencies.cmake DESTINATION ${package_dir} COMPONENT library)

# for projects without CMake; the folders may be absolute. The file finds the prefix from where it lies.
cmake_path(ABSOLUTE_PATH CMAKE_INSTALL_INCLUDEDIR BASE_DIRECTORY "\${prefix}" OUTPUT_VARIABLE pkg_config_includes)
if(IS_ABSOLUTE ${CMAKE_INSTALL_LIBDIR})
  set(pkg_config_prefix ${CMAKE_INSTALL_PREFIX})
else()
  string(REGEX REPLACE "[^/]+" ".." way_up "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
  set(pkg_config_prefix "\${pcfiledir}/${way_up}")
endif()
configure_file(cmake/CGAL_ext.pc.in ${PROJECT_BINARY_DIR}/CGAL_ext.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/CGAL_ext.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT library)

if(TARGET square_map)
  install(TARGETS square_map RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT command)
  install(FILES examples/Square_parameterization/page/three_license.txt DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT command)
  install(FILES cmake/square_map.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME square_map
          COMPONENT command)
  # the manual page is made of what the command says of itself
  find_package(Python3 COMPONENTS Interpreter)
  if(Python3_FOUND)
    set(manual_page ${PROJECT_BINARY_DIR}/square_map.1)
    add_custom_command(OUTPUT ${manual_page}
                       COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/cmake/make_manual_page.py $<TARGET_FILE:square_map>
                               ${PROJECT_SOURCE_DIR}/cmake/square_map.1.in ${manual_page}
                       DEPENDS square_map cmake/make_manual_page.py cmake/square_map.1.in VERBATIM)
    add_custom_target(manual_page ALL DEPENDS ${manual_page})
    install(FILES ${manual_page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT command)
  else()
    message(STATUS "NOTICE: no manual page of square_map: Python is not found")
  endif()
endif()

install(FILES README.md CHANGES.md LICENSE package_info/Square_parameterization/debian/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT library)
install(DIRECTORY ${PROJECT_BINARY_DIR}/doc/html DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documentation OPTIONAL)
