#pragma once
// Where the tests find the checkout and the build. Only tests/paths.cpp is compiled with these
// folders: the objects of all others are the same in every checkout, and compilers' caches find
// them.
#include <string>

namespace burl::test {

std::string source_folder();                     ///< the checkout
std::string case_file(const std::string& name);  ///< of tests/cases/
std::string binary_folder();                     ///< of the build
std::string mesh_folder();                       ///< the sample meshes' files, made by the build

}  // namespace burl::test
