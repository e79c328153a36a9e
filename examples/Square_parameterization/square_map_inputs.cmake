# The readers of all formats, and what makes meshes of what they read, compiled once for square_map and the benchmarks, which can be built without each other.
include_guard(GLOBAL)
add_library(square_map_inputs STATIC ${CMAKE_CURRENT_LIST_DIR}/src/square_map/read_soup.cpp
                                     ${CMAKE_CURRENT_LIST_DIR}/src/square_map/read_surface.cpp)
target_link_libraries(square_map_inputs PRIVATE CGAL_ext::core CGAL_ext_warnings)
