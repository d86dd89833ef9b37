# The include rule's own test: each file of violations/ breaks it, and where it says so; the rule must
# name exactly those lines. Usage: cmake -P include_rule_refuses.cmake
cmake_minimum_required(VERSION 3.25)
set(root ${CMAKE_CURRENT_LIST_DIR}/violations)
execute_process(COMMAND ${CMAKE_COMMAND} -DROOT=${root} -P ${CMAKE_CURRENT_LIST_DIR}/include_rule.cmake
    RESULT_VARIABLE result ERROR_VARIABLE output)
if(result EQUAL 0)
    message(FATAL_ERROR "the rule accepts a tree that breaks it")
endif()
set(expected
    "app/render.cpp:3: must not include glad/gl.h"
    "app/render.cpp:4: must not include GL/osmesa.h"
    "atlas/upward.cpp:2: must not include app/recipe.h"
    "atlas/upward.cpp:3: must not include ../procedural/texture.h"
    "atlas/upward.cpp:4: must not include procedural/texture.h"
    "procedural/noise.cpp:3: must not include atlas/mesh.h"
    "procedural/synthesize.cpp:3: must not include app/recipe.h")
foreach(line ${expected})
    if(NOT output MATCHES "(^|\n)${line}: ")
        message(FATAL_ERROR "the rule did not say \"${line}\"; it said:\n${output}")
    endif()
endforeach()
list(LENGTH expected count)
if(NOT output MATCHES "${count} violations")
    message(FATAL_ERROR "the rule refused more than ${count} lines:\n${output}")
endif()
