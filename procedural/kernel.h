#pragma once
// How the corners of lattice cells come to the texels. All ways give the same bits; `automatic` is
// the fastest of them, batch by batch.
#include <array>
#include <string_view>

namespace burl {

enum class Kernel {
    automatic,
    direct,  ///< every texel hashes the eight corners of its own cell
    share,   ///< texels in a row that lie in one cell share its corners
};

struct NamedKernel {
    std::string_view name;
    Kernel kernel;
};
inline constexpr std::array kernel_names{NamedKernel{"auto", Kernel::automatic},
                                         NamedKernel{"direct", Kernel::direct},
                                         NamedKernel{"share", Kernel::share}};

}  // namespace burl
