# Writes pages and looks at them in a browser: of a closed surface on its rectangle, and of 200000 faces, whose size is
# bounded. How long the first picture takes is printed: it depends on the machine.
function(check_page name options)
  execute_process(COMMAND ${SQUARE_MAP} ${ARGN} --report ${FOLDER}/${name}.html --quiet COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${PYTHON} ${CMAKE_CURRENT_LIST_DIR}/check_page.py ${CHROMIUM} ${FOLDER}/${name}.html
                          --screenshot ${FOLDER}/${name}.png ${options}
                  COMMAND_ERROR_IS_FATAL ANY)
endfunction()

check_page(page "" ${MESH} --aspect best)
execute_process(COMMAND ${PYTHON} ${CMAKE_CURRENT_LIST_DIR}/write_hills.py 200000 ${FOLDER}/hills.off
                COMMAND_ERROR_IS_FATAL ANY)
check_page(large_page --unused ${FOLDER}/hills.off)
file(SIZE ${FOLDER}/large_page.html bytes)
if(bytes GREATER 25000000)
  message(FATAL_ERROR "a page of 200000 faces has ${bytes} bytes")
endif()
