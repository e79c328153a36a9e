# Installs the package and builds a user's project against it: from the build folder as it is, and from another one with
# folders for headers and libraries of the installer's choice.
# cmake -D BINARY_DIR=... -D PACKAGE_DIR=... -D SOURCE_DIR=... -D GENERATOR=... -P test_consumer.cmake
include(${CMAKE_CURRENT_LIST_DIR}/../run.cmake)

# installs the package of a build folder, and builds and runs the user's project, which is told where the package is
function(check_consumer build_folder folder)
  run(${CMAKE_COMMAND} --install ${build_folder} --prefix ${folder}/installed)
  run(${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${folder}/build -G ${GENERATOR} -D CMAKE_BUILD_TYPE=Release
      -D EXPECTED_PREFIX=${folder}/installed ${ARGN})
  run(${CMAKE_COMMAND} --build ${folder}/build)
  run(${folder}/build/consumer)
endfunction()

set(folder ${BINARY_DIR}/consumer)
file(REMOVE_RECURSE ${folder})
check_consumer(${BINARY_DIR} ${folder}/as_is -D CMAKE_PREFIX_PATH=${folder}/as_is/installed)

run(${CMAKE_COMMAND} -S ${PACKAGE_DIR} -B ${folder}/package -G ${GENERATOR} -D CMAKE_BUILD_TYPE=Release
    -D CMAKE_INSTALL_INCLUDEDIR=headers/of/packages -D CMAKE_INSTALL_LIBDIR=lib/other -D CGAL_EXT_BUILD_EXAMPLES=OFF
    -D CGAL_EXT_BUILD_TESTS=OFF -D CGAL_EXT_BUILD_BENCHMARKS=OFF -D CGAL_EXT_BUILD_DOCUMENTATION=OFF)
run(${CMAKE_COMMAND} --build ${folder}/package)
check_consumer(${folder}/package ${folder}/other_folders
               -D CGAL_ext_DIR=${folder}/other_folders/installed/lib/other/cmake/CGAL_ext)
foreach(path headers/of/packages/CGAL_ext lib/other/cmake/CGAL_ext)
  if(NOT IS_DIRECTORY ${folder}/other_folders/installed/${path})
    message(FATAL_ERROR "nothing was installed into ${path}")
  endif()
endforeach()
