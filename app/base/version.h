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

/// Makes all kernels of the process use `level`, so that benchmarks can measure a lesser machine:
/// one of simd_targets(), which this machine has and the kernels are compiled for. Throws
/// Error(usage) naming them for any other.
void limit_simd(const std::string& level);

}  // namespace burl
