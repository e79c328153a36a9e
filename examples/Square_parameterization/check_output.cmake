# Runs an example and checks that it ends with status 0 and prints what is expected:
#
#   cmake -D PROGRAM=... -D EXPECTED=FILE -P check_output.cmake
#
# FILE holds one regular expression of CMake for all that is written to the standard output. Two alternatives are those of
# CGAL 5.5 and 6.1, which simplify the copies of closed surfaces differently, on which cuts are found.
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE output ERROR_VARIABLE errors RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} ended with ${status}\n${output}${errors}")
endif()
file(READ ${EXPECTED} expected)
if(NOT output MATCHES "^${expected}$")
  message(FATAL_ERROR "${PROGRAM} printed\n${output}instead of what ${EXPECTED} says\n${expected}")
endif()
