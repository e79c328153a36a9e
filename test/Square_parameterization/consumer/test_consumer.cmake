# Installs the package and builds a user's project against it: from the build folder as it is, and from another one with
# folders for headers and libraries of the installer's choice.
# cmake -D BINARY_DIR=... -D PACKAGE_DIR=... -D SOURCE_DIR=... -D GENERATOR=... -P test_consumer.cmake
include(${CMAKE_CURRENT_LIST_DIR}/../run.cmake)

# installs the package of a build folder, and builds and runs the user's project, which is told where the package is, with the
# given source; compiled for one small map, and so without optimisation
function(check_consumer build_folder folder source)
  run(${CMAKE_COMMAND} --install ${build_folder} --prefix ${folder}/installed)
  run(${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${folder}/build -G ${GENERATOR} -D CMAKE_BUILD_TYPE=Release
      -D CMAKE_CXX_FLAGS_RELEASE=-DNDEBUG -D EXPECTED_PREFIX=${folder}/installed -D SOURCE=${source} ${ARGN})
  run(${CMAKE_COMMAND} --build ${folder}/build)
  run(${folder}/build/consumer)
endfunction()

set(folder ${BINARY_DIR}/consumer)
file(REMOVE_RECURSE ${folder})
check_consumer(${BINARY_DIR} ${folder}/as_is consumer.cpp -D CMAKE_PREFIX_PATH=${folder}/as_is/installed)

# the library alone takes nothing of what the tests and the command need
set(not_needed "")
foreach(package Catch2 nlohmann_json PNG tinyexr TinyGLTF OpenMesh Doxygen Python3)
  list(APPEND not_needed -D CMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()
run(${CMAKE_COMMAND} --preset install -S ${PACKAGE_DIR} -B ${folder}/package -G ${GENERATOR} ${not_needed}
    -D CMAKE_INSTALL_INCLUDEDIR=headers/of/packages -D CMAKE_INSTALL_LIBDIR=lib/other)
run(${CMAKE_COMMAND} --build ${folder}/package)
check_consumer(${folder}/package ${folder}/other_folders small_consumer.cpp
               -D CGAL_ext_DIR=${folder}/other_folders/installed/lib/other/cmake/CGAL_ext)
foreach(path headers/of/packages/CGAL_ext lib/other/cmake/CGAL_ext)
  if(NOT IS_DIRECTORY ${folder}/other_folders/installed/${path})
    message(FATAL_ERROR "nothing was installed into ${path}")
  endif()
endforeach()

# a project without CMake
find_program(pkg_config pkg-config)
if(pkg_config)
  set(ENV{PKG_CONFIG_PATH} ${folder}/other_folders/installed/lib/other/pkgconfig)
  execute_process(COMMAND ${pkg_config} --cflags --libs CGAL_ext OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE
                  COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  run(c++ -std=c++17 ${SOURCE_DIR}/small_consumer.cpp ${flags} -o ${folder}/without_cmake)
  run(${folder}/without_cmake)
else()
  message("NOTICE: pkg-config is not found: CGAL_ext.pc is not tested")
endif()
