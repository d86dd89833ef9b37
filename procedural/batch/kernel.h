#pragma once
// Kernels: the ways to evaluate lattice noise for spans of texels. `direct` and `share` give the
// same bits; `scanline` rounds otherwise, within the same error bound. `automatic` takes the
// fastest of them: whether a span is scanned depends on that span alone, `direct` or `share` is
// chosen batch by batch.
#include <array>
#include <string_view>

namespace burl {

enum class Kernel {
    automatic,
    direct,    ///< every texel hashes the eight corners of its own cell
    share,     ///< texels in a row that lie in one cell share its corners
    scanline,  ///< between lattice planes the noise is a polynomial of the texel's number
};

struct NamedKernel {
    std::string_view name;
    Kernel kernel;
};
inline constexpr std::array kernel_names{
    NamedKernel{"auto", Kernel::automatic}, NamedKernel{"direct", Kernel::direct},
    NamedKernel{"share", Kernel::share}, NamedKernel{"scanline", Kernel::scanline}};

}  // namespace burl
