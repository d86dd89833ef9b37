# Every C++ source is as clang-format leaves it. Usage: cmake -DROOT=folder -P format.cmake
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/files.cmake)
find_program(clang_format NAMES clang-format-14 clang-format)
if(NOT clang_format)
    message("skipped: clang-format is not installed")
    return()
endif()
house_files(files *.h *.cpp)
execute_process(COMMAND ${clang_format} --dry-run -Werror ${files} WORKING_DIRECTORY ${ROOT}
    RESULT_VARIABLE result)
if(NOT result EQUAL 0)
    message(FATAL_ERROR "run clang-format -i on the files named above")
endif()
