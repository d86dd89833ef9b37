#pragma once
// The library's version, which is the program's: MAJOR.MINOR.PATCH as semver.org has it. Programs
// that were linked with one version run with every later one of the same MAJOR.
#include <string>

#include "app/library/error.h"

namespace burl::library {

/// The version of the library that runs, such as "0.1.0". Never throws but std::bad_alloc.
BURL_API std::string version();

/// The instruction set that the library's kernels use on this machine, such as "AVX2".
BURL_API std::string simd();

}  // namespace burl::library
