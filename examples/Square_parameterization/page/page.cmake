# The page of `square_map --report`: page.html with its style and scripts, and three.js of Debian's package libjs-three,
# as a source file of the command. It needs no other file where it runs.
set(page_folder ${CMAKE_CURRENT_LIST_DIR})
find_file(CGAL_EXT_THREE_JS three.min.js PATHS /usr/share/javascript/three /usr/share/nodejs/three/build NO_DEFAULT_PATH
          REQUIRED DOC "three.js 111, one script")
get_filename_component(three_folder ${CGAL_EXT_THREE_JS} DIRECTORY)
find_file(CGAL_EXT_THREE_CONTROLS TrackballControls.js PATHS ${three_folder}/examples/js/controls NO_DEFAULT_PATH REQUIRED
          DOC "the controls of the same version of three.js")

set(page_parts page.html page.css data.js materials.js views.js words.js main.js three_license.txt)
list(TRANSFORM page_parts PREPEND ${page_folder}/)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${page_parts} ${CGAL_EXT_THREE_JS}
                                                                ${CGAL_EXT_THREE_CONTROLS})

file(READ ${CGAL_EXT_THREE_JS} THREE_SCRIPT)
file(READ ${CGAL_EXT_THREE_CONTROLS} THREE_CONTROLS)
file(READ ${page_folder}/three_license.txt THREE_LICENSE)
file(READ ${page_folder}/page.css PAGE_STYLE)
set(PAGE_SCRIPT "")
foreach(part data materials views words main)
  file(READ ${page_folder}/${part}.js text)
  string(APPEND PAGE_SCRIPT "${text}")
endforeach()
file(READ ${page_folder}/page.html page)
foreach(part PAGE_STYLE THREE_LICENSE THREE_SCRIPT THREE_CONTROLS PAGE_SCRIPT)
  string(REPLACE "@${part}@" "${${part}}" page "${page}")
endforeach()
string(REPLACE "<!-- data -->" ")page\";\n}\n\nstd::string_view page_after_data()\n{\n  return R\"page(" page "${page}")
# written only when it has changed, so that it is not compiled in vain
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/page_template.cpp @ONLY NEWLINE_STYLE UNIX CONTENT
"#include \"square_map/page_template.h\"

namespace square_map {

std::string_view page_before_data()
{
  return R\"page(@page@)page\";
}

} // namespace square_map
")
add_library(square_map_page STATIC ${CMAKE_CURRENT_BINARY_DIR}/page_template.cpp)
target_compile_features(square_map_page PRIVATE cxx_std_17)
target_include_directories(square_map_page PRIVATE include)
