#pragma once
// What exactly ran: our version, the libraries' versions and the SIMD level chosen at run time.
#include <string>
#include <utility>
#include <vector>

namespace burl {

std::string burl_version();

/// Name and version of every library, and "simd" with the instruction set the kernels use on this
/// machine.
std::vector<std::pair<std::string, std::string>> component_versions();

/// All of it, a line each.
std::string version_text();

}  // namespace burl
