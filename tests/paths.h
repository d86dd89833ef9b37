#pragma once
// The folders of the checkout and of the build. Only tests/paths.cpp is compiled with them: all
// other objects are the same in every checkout, so that compiler caches can share them.
#include <string>

namespace burl::test {

std::string source_folder();                     ///< the checkout
std::string case_file(const std::string& name);  ///< path of a file in tests/cases/
std::string binary_folder();                     ///< folder of the build
std::string mesh_folder();  ///< folder of the sample meshes' files, which the build makes

}  // namespace burl::test
