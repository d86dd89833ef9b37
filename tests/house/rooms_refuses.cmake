# The rooms' own test: what is wrong with violations/ and its list must be named, line by line, and nothing else.
# Usage: cmake -P rooms_refuses.cmake
cmake_minimum_required(VERSION 3.25)
set(root ${CMAKE_CURRENT_LIST_DIR}/violations)
execute_process(COMMAND ${CMAKE_COMMAND} -DROOT=${root} -DROOMS=${root}/rooms.txt -P ${CMAKE_CURRENT_LIST_DIR}/rooms.cmake
    RESULT_VARIABLE result ERROR_VARIABLE output)
if(result EQUAL 0)
    message(FATAL_ERROR "the rule accepts a tree that breaks it")
endif()
set(expected
    "rooms.txt: atlas/base includes app/draw, which does not stand before it"
    "rooms.txt: \"app/one: a purpose that is no sentence\" is neither"
    "rooms.txt: nothing is in shaders/draw"
    "shaders/noise/value.glsl:1: must not need draw/mesh.frag: shaders/noise does not include shaders/draw"
    "rooms.txt: nothing is in app/empty"
    "app/draw/render.cpp:3: must not include procedural/noise/noise.h: app/draw does not include procedural/noise"
    "app/draw/render.cpp:4: must not include glad/gl.h: app/draw does not include OpenGL"
    "app/draw/render.cpp:5: must not include GL/osmesa.h: app/draw does not include OpenGL"
    "app/homeless.cpp: is in no room"
    "atlas/base/upward.cpp:3: must not include ../procedural/noise/noise.h: name it from the top folder"
    "atlas/base/upward.cpp:4: must not include procedural/noise/noise.h: atlas/base does not include procedural/noise"
    "atlas/base/upward.cpp:7: must not include tests/paths.h: tests is for itself")
foreach(line ${expected})
    string(FIND "\n${output}" "\n${line}" place)
    if(place EQUAL -1)
        message(FATAL_ERROR "the rule did not say \"${line}\"; it said:\n${output}")
    endif()
endforeach()
list(LENGTH expected count)
if(NOT output MATCHES "[^0-9]${count} violations")
    message(FATAL_ERROR "the rule refused more than ${count} lines:\n${output}")
endif()
