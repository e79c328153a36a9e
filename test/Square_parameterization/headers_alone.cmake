# Adds the targets headers_alone and headers_alone_core, which compile every header by itself: header-only, and as seen
# by what links with the core. They are not part of the default build, and CTest does not run them:
#   cmake --build build --target headers_alone headers_alone_core
file(GLOB_RECURSE headers RELATIVE ${PROJECT_SOURCE_DIR}/include CONFIGURE_DEPENDS
     ${PROJECT_SOURCE_DIR}/include/CGAL_ext/*.h)
set(sources)
foreach(header IN LISTS headers)
  string(MAKE_C_IDENTIFIER ${header} name)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/headers_alone/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "#include <${header}>\n" @ONLY)
  list(APPEND sources ${source})
endforeach()
add_library(headers_alone OBJECT EXCLUDE_FROM_ALL ${sources})
target_compile_options(headers_alone PRIVATE -fsyntax-only)
target_link_libraries(headers_alone PRIVATE CGAL_ext::CGAL_ext CGAL_ext_warnings)
add_library(headers_alone_core OBJECT EXCLUDE_FROM_ALL ${sources})
target_compile_options(headers_alone_core PRIVATE -fsyntax-only)
target_compile_definitions(headers_alone_core PRIVATE CGAL_EXT_COMPILED_CORE)
target_link_libraries(headers_alone_core PRIVATE CGAL_ext::CGAL_ext CGAL_ext_warnings)
