# What the house tests share: the sources under ROOT, and naming a place in one of them.

# Sets `out` to the sources below ROOT, relative to it, that match one of the patterns after it.
function(house_files out)
    set(found "")
    foreach(folder app atlas procedural shaders tests assets)
        foreach(pattern ${ARGN})
            file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/${folder}/${pattern})
            list(APPEND found ${files})
        endforeach()
    endforeach()
    list(FILTER found EXCLUDE REGEX "^tests/house/violations/")
    list(SORT found)
    set(${out} "${found}" PARENT_SCOPE)
endfunction()

# Sets `out` to the number of the line of `content` on which `text` first stands.
function(line_of out content text)
    string(FIND "${content}" "${text}" place)
    string(SUBSTRING "${content}" 0 ${place} before)
    string(REGEX MATCHALL "\n" breaks "${before}")
    list(LENGTH breaks count)
    math(EXPR line "${count} + 1")
    set(${out} ${line} PARENT_SCOPE)
endfunction()

# Prints each complaint on a line of its own and fails when there is one.
function(report complaints)
    foreach(complaint ${complaints})
        message("${complaint}")
    endforeach()
    list(LENGTH complaints count)
    if(count)
        message(FATAL_ERROR "${count} violations")
    endif()
endfunction()
