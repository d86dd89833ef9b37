# The viewer of web pages: the scripts of this folder and three.js as one script, bundled by esbuild (Debian's) and embedded in the
# program. It is empty, and `burl page` says so, where esbuild is not installed or three.js cannot be fetched; BURL_THREE may name a
# folder that holds three.js already.
set(three 0.187.0)
set(hash ff540832ded0cfe919764d24a3d88f3e2a05f23303f876423e4f893841e90728)
set(BURL_THREE "" CACHE PATH "Folder of three.js ${three}, as npm unpacks it; empty: fetched from npm's registry")
set(modules ${CMAKE_CURRENT_BINARY_DIR}/viewer/node_modules)
set(BURL_VIEWER_DIR ${CMAKE_CURRENT_BINARY_DIR}/viewer/made)
find_program(ESBUILD esbuild)

# Fetches three.js into `modules`, once.
function(fetch_three)
    set(archive ${CMAKE_CURRENT_BINARY_DIR}/viewer/three-${three}.tgz)
    if(EXISTS ${modules}/three/package.json OR NOT ESBUILD)
        return()
    endif()
    message(STATUS "Fetching three.js ${three}")
    file(DOWNLOAD https://registry.npmjs.org/three/-/three-${three}.tgz ${archive} STATUS status INACTIVITY_TIMEOUT 20 TIMEOUT 300)
    list(GET status 0 code)
    if(code EQUAL 0)
        file(SHA256 ${archive} found)
    endif()
    if(NOT found STREQUAL hash)
        list(GET status 1 reason)
        message(STATUS "three.js could not be fetched (${reason}), so there will be no `burl page`")
        file(REMOVE ${archive})
        return()
    endif()
    file(ARCHIVE_EXTRACT INPUT ${archive} DESTINATION ${modules} PATTERNS package/package.json package/LICENSE package/build/*
        package/examples/jsm/loaders/* package/examples/jsm/utils/*)
    file(RENAME ${modules}/package ${modules}/three)
    file(REMOVE ${archive})
endfunction()

# What an earlier configuration fetched or named gives way, and the script that was made of it.
set(before "")
if(IS_SYMLINK ${modules}/three)
    file(READ_SYMLINK ${modules}/three before)
endif()
if(NOT before STREQUAL "${BURL_THREE}")
    file(REMOVE_RECURSE ${modules}/three ${BURL_VIEWER_DIR}/viewer.js)
endif()
if(BURL_THREE)
    file(MAKE_DIRECTORY ${modules})
    file(CREATE_LINK ${BURL_THREE} ${modules}/three SYMBOLIC)
    if(NOT EXISTS ${modules}/three/package.json)
        message(STATUS "There is no three.js in ${BURL_THREE}, so there will be no `burl page`")
    endif()
else()
    fetch_three()
endif()
if(ESBUILD AND EXISTS ${modules}/three/package.json)
    set_property(GLOBAL PROPERTY BURL_VIEWER_LICENSE ${modules}/three/LICENSE)  # for the package's copyright
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*.js ${CMAKE_CURRENT_LIST_DIR}/*.css)
    add_custom_command(OUTPUT ${BURL_VIEWER_DIR}/viewer.js
        COMMAND ${CMAKE_COMMAND} -E env NODE_PATH=${modules} ${ESBUILD} ${CMAKE_CURRENT_LIST_DIR}/main.js --bundle --minify
            --format=iife --loader:.css=text --charset=ascii --legal-comments=inline --log-level=warning --outfile=${BURL_VIEWER_DIR}/viewer.js
        DEPENDS ${sources} VERBATIM)
else()
    file(WRITE ${BURL_VIEWER_DIR}/viewer.js "")
endif()
