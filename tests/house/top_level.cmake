# The top level is fixed: new things go into one of its folders. Hidden files and the ignored output
# folders do not count. Usage: cmake -DROOT=folder -P top_level.cmake
cmake_minimum_required(VERSION 3.25)
set(expected CMakeLists.txt CMakePresets.json CONTRIBUTING.md LICENSE README.md app assets atlas check demo docs
    packages.txt procedural shaders tests)
file(GLOB found RELATIVE ${ROOT} ${ROOT}/*)
list(FILTER found EXCLUDE REGEX "^(\\..*|build|out)$")
foreach(name ${found})
    if(NOT name IN_LIST expected)
        message(SEND_ERROR "${name} is not part of the top level: move it into one of the folders")
    endif()
endforeach()
foreach(name ${expected} .ci/run .clang-format .gitignore)
    if(NOT EXISTS ${ROOT}/${name})
        message(SEND_ERROR "${name} is missing")
    endif()
endforeach()
