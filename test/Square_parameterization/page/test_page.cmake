# Writes pages and looks at them in a browser: of a closed surface on its rectangle, and of 200000 faces. First pictures are
# bounded in seconds of processors, of which a page of that size takes less than 3 where there is no other work: other
# work adds some.
function(check_page name seconds options)
  execute_process(COMMAND ${SQUARE_MAP} ${ARGN} --report ${FOLDER}/${name}.html --quiet COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${PYTHON} ${CMAKE_CURRENT_LIST_DIR}/check_page.py ${CHROMIUM} ${FOLDER}/${name}.html
                          --screenshot ${FOLDER}/${name}.png --processor-seconds ${seconds} ${options}
                  COMMAND_ERROR_IS_FATAL ANY)
endfunction()

check_page(page 4 "" ${MESH} --aspect best)
execute_process(COMMAND ${PYTHON} ${CMAKE_CURRENT_LIST_DIR}/write_hills.py 200000 ${FOLDER}/hills.off
                COMMAND_ERROR_IS_FATAL ANY)
check_page(large_page 6 --unused ${FOLDER}/hills.off)
file(SIZE ${FOLDER}/large_page.html bytes)
if(bytes GREATER 25000000)
  message(FATAL_ERROR "a page of 200000 faces has ${bytes} bytes")
endif()
