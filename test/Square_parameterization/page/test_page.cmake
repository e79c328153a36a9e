# writes the page of a real mesh and looks at it in a browser, which a loaded machine gives more time
execute_process(COMMAND ${SQUARE_MAP} ${MESH} --report ${FOLDER}/page.html --quiet COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PYTHON} ${CMAKE_CURRENT_LIST_DIR}/check_page.py ${CHROMIUM} ${FOLDER}/page.html
                        --screenshot ${FOLDER}/page.png --seconds 20 COMMAND_ERROR_IS_FATAL ANY)
