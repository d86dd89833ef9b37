# The include rule's own test: each file of violations/ breaks it, and where it says so; the rule must
# name exactly those lines. Usage: cmake -P include_rule_refuses.cmake
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/files.cmake)
expect_violations(include_rule
    "app/render.cpp:3: must not include glad/gl.h"
    "app/render.cpp:4: must not include GL/osmesa.h"
    "atlas/upward.cpp:2: must not include app/recipe/recipe.h"
    "atlas/upward.cpp:3: must not include ../procedural/model/texture.h"
    "atlas/upward.cpp:4: must not include procedural/model/texture.h"
    "procedural/noise/noise.cpp:3: must not include atlas/mesh/mesh.h"
    "procedural/fill/synthesize.cpp:3: must not include app/recipe/recipe.h")
