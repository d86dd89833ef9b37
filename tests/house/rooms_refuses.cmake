# The rooms' own test: what is wrong with violations/ and its list. Usage: cmake -P rooms_refuses.cmake
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/files.cmake)
expect_violations(rooms
    "rooms.txt: atlas/base includes atlas/top, which does not stand before it"
    "rooms.txt: procedural/noise is in two rooms"
    "rooms.txt: \"app/one: a purpose that is no sentence\" is neither"
    "rooms.txt: there is no atlas/vanished.h or .cpp"
    "app/gl/device/context.cpp: is in no room"
    "app/render.cpp: must not include procedural/model/texture.h: app/two does not include procedural/all"
    "atlas/upward.cpp: must not include procedural/model/texture.h: atlas/base does not include procedural/all")
