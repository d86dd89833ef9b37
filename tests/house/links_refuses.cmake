# The links' own test: what is dead in violations/docs/ must be named, line by line, and nothing else.
# Usage: cmake -P links_refuses.cmake
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND ${CMAKE_COMMAND} -DROOT=${CMAKE_CURRENT_LIST_DIR}/violations -P ${CMAKE_CURRENT_LIST_DIR}/links.cmake
    RESULT_VARIABLE result ERROR_VARIABLE output)
if(result EQUAL 0)
    message(FATAL_ERROR "the rule accepts a page with dead links")
endif()
set(expected
    "docs/dead.md:4: gone.png leads nowhere: there is no docs/gone.png"
    "docs/dead.md:4: ../gone/page.md leads nowhere: there is no gone/page.md"
    "docs/dead.md:5: dead.md#gone leads nowhere: docs/dead.md has no heading gone"
    "docs/dead.md:5: #gone leads nowhere: docs/dead.md has no heading gone"
    "docs/dead.md:6: gone.png leads nowhere: there is no docs/gone.png"
    "docs/dead.md: there is no docs/gone.md"
    "docs/dead.md: there is no atlas/base/gone.cpp")
foreach(line ${expected})
    string(FIND "\n${output}" "\n${line}" place)
    if(place EQUAL -1)
        message(FATAL_ERROR "the rule did not say \"${line}\"; it said:\n${output}")
    endif()
endforeach()
list(LENGTH expected count)
if(NOT output MATCHES "[^0-9]${count} violations")
    message(FATAL_ERROR "the rule refused more than ${count} links:\n${output}")
endif()
