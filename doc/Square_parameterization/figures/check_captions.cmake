# Fails when the captions of the manual lack a number with decimals that the figures print.
#
#     cmake -D FIGURES=figures.txt -D MANUAL=Square_parameterization.txt -P check_captions.cmake

file(STRINGS ${FIGURES} printed)
file(READ ${MANUAL} manual)
string(REPLACE ";" "," manual "${manual}")
string(REGEX MATCHALL "cgalFigureBegin[^\\\\]*\\\\cgalFigureEnd" captions "${manual}")
foreach(line IN LISTS printed)
  string(REGEX MATCHALL "[0-9]+\\.[0-9]+" numbers "${line}")
  foreach(number IN LISTS numbers)
    string(FIND "${captions}" "${number}" place)
    if(place EQUAL -1)
      message(SEND_ERROR "no caption has the ${number} of '${line}'")
    endif()
  endforeach()
endforeach()
