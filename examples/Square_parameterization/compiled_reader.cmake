# CGAL's readers of all formats, compiled once for the examples, the figures of the manual, and the benchmarks, which can be
# built without the others.
include_guard(GLOBAL)
add_library(compiled_reader STATIC ${CMAKE_CURRENT_LIST_DIR}/src/compiled_reader.cpp)
target_link_libraries(compiled_reader PRIVATE CGAL_ext::CGAL_ext CGAL_ext_warnings)
