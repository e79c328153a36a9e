# Installs the package into a folder of its own and builds a user's project against it.
# cmake -D BINARY_DIR=... -D SOURCE_DIR=... -D GENERATOR=... -P test_consumer.cmake
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed: ${ARGN}")
  endif()
endfunction()

set(folder ${BINARY_DIR}/consumer)
file(REMOVE_RECURSE ${folder})
run(${CMAKE_COMMAND} --install ${BINARY_DIR} --prefix ${folder}/installed)
run(${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${folder}/build -G ${GENERATOR} -D CMAKE_BUILD_TYPE=Release
    -D CMAKE_PREFIX_PATH=${folder}/installed)
run(${CMAKE_COMMAND} --build ${folder}/build)
run(${folder}/build/consumer)
