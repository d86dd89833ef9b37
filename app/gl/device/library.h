#pragma once
// OpenGL's window-system libraries by dlopen, so that neither the libraries nor their headers are
// dependencies of the build.
#include <dlfcn.h>

#include <array>
#include <span>
#include <string>
#include <utility>

namespace burl {

/// The OpenGL core versions that contexts are requested with, in turn, since a library may give
/// exactly the version requested.
inline constexpr std::array<std::pair<int, int>, 8> gl_versions{
    {{4, 6}, {4, 5}, {4, 4}, {4, 3}, {4, 2}, {4, 1}, {4, 0}, {3, 3}}};

/// The first library that can be loaded, and its name; null where none can. It stays loaded until
/// the program ends, since LLVM inside drivers does not survive unloading.
inline std::pair<void*, std::string> open_library(std::span<const char* const> names) {
    for (const char* name : names)
        if (void* const library = dlopen(name, RTLD_NOW | RTLD_LOCAL)) return {library, name};
    return {};
}

/// Looks up a function of the library; false where it has none of that name.
template <class Function>
bool find_function(void* library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(library, name));
    return function != nullptr;
}

}  // namespace burl
