# The library's and the Python module's part of `cmake --install`: components library (libburl.so.0), dev (headers, CMake's
# files, the example) and python.
include(CMakePackageConfigHelpers)
set(burl_cmake ${BURL_LIBDIR}/cmake/burl)
# Parts of the library by name; all are in the one file, since a program that evaluates or measures bakes, too, before long.
foreach(part atlas procedural)
    add_library(burl_library_${part} INTERFACE)
    set_target_properties(burl_library_${part} PROPERTIES EXPORT_NAME ${part})
    target_link_libraries(burl_library_${part} INTERFACE burl_library)
endforeach()
target_include_directories(burl_library INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
install(TARGETS burl_library burl_library_atlas burl_library_procedural EXPORT burl
    LIBRARY DESTINATION ${BURL_LIBDIR} COMPONENT library NAMELINK_COMPONENT dev
    PUBLIC_HEADER DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/burl COMPONENT dev)
install(EXPORT burl NAMESPACE burl:: FILE burlConfig.cmake DESTINATION ${burl_cmake} COMPONENT dev)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/burlConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/burlConfigVersion.cmake DESTINATION ${burl_cmake} COMPONENT dev)
install(DIRECTORY ${CMAKE_CURRENT_LIST_DIR}/example/ DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libburl-dev/examples COMPONENT dev)

if(TARGET burl_python)
    # Where Debian's Python looks; elsewhere PYTHONPATH names it.
    set(python_dir lib/python3/dist-packages/burl)
    file(RELATIVE_PATH to_library /${python_dir} /${BURL_LIBDIR})
    set_target_properties(burl_python PROPERTIES INSTALL_RPATH "$ORIGIN/${to_library}")
    install(TARGETS burl_python LIBRARY DESTINATION ${python_dir} COMPONENT python)
    install(DIRECTORY ${BURL_PYTHON_DIR}/burl/ DESTINATION ${python_dir} COMPONENT python
        FILES_MATCHING PATTERN *.py PATTERN *.pyi PATTERN py.typed PATTERN __pycache__ EXCLUDE)
    # Below /usr the library is found without a path.
    install(CODE "if(CMAKE_INSTALL_PREFIX STREQUAL \"/usr\")
        file(RPATH_REMOVE FILE \"\$ENV{DESTDIR}/usr/${python_dir}/$<TARGET_FILE_NAME:burl_python>\")
    endif()" COMPONENT python)
endif()

# Pages of the library, where Doxygen is: build/release/api/html.
find_program(DOXYGEN doxygen)
if(DOXYGEN)
    configure_file(${CMAKE_CURRENT_LIST_DIR}/Doxyfile.in ${CMAKE_CURRENT_BINARY_DIR}/Doxyfile @ONLY)
    add_custom_target(burl_api COMMAND ${DOXYGEN} ${CMAKE_CURRENT_BINARY_DIR}/Doxyfile VERBATIM)
endif()
