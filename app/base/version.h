#pragma once
// The versions of Burl and its libraries, and the SIMD level chosen at run time.
#include <string>
#include <utility>
#include <vector>

namespace burl {

std::string burl_version();

/// Name and version of every library, and "simd" with the instruction set that the kernels use on
/// this machine.
std::vector<std::pair<std::string, std::string>> component_versions();

/// Burl's version and all component_versions(), one per line.
std::string version_text();

}  // namespace burl
