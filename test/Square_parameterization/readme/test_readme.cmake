# Installs the package and compiles the C++ of README.md against it, without making code.
# cmake -D BINARY_DIR=... -D README=... -D SOURCE_DIR=... -D GENERATOR=... -P test_readme.cmake
include(${CMAKE_CURRENT_LIST_DIR}/../run.cmake)

set(folder ${BINARY_DIR}/readme)
file(REMOVE_RECURSE ${folder})
run(${CMAKE_COMMAND} --install ${BINARY_DIR} --prefix ${folder}/installed)
run(${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${folder}/build -G ${GENERATOR} -D CMAKE_BUILD_TYPE=Release
    -D CMAKE_PREFIX_PATH=${folder}/installed -D README=${README})
run(${CMAKE_COMMAND} --build ${folder}/build)
