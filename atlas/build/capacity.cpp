#include "atlas/build/capacity.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>

namespace burl {
namespace {

/// Number of shells up to which the layout, which knows their areas, decides whether they
/// fit.
constexpr std::uint32_t many_shells = 64;

/// Smallest size with so many texels (a power of two for quad); 0 where it exceeds max_atlas_size.
std::uint32_t size_for(double texels, AtlasKind kind) {
    auto size = static_cast<std::uint64_t>(std::ceil(std::sqrt(texels)));
    if (kind == AtlasKind::quad) size = std::bit_ceil(size);
    return size <= max_atlas_size ? static_cast<std::uint32_t>(size) : 0;
}

}  // namespace

Capacity capacity(std::uint64_t triangles, const AtlasOptions& options) {
    Capacity result;
    result.triangles = triangles;
    result.columns = options.columns();
    result.rows = options.rows();
    const double count = double(triangles);
    result.texels_per_triangle =
        triangles > 0 ? double(result.columns) * result.rows / count : good_texels_per_triangle;
    result.good_size = size_for(good_texels_per_triangle * count, options.kind);
    result.least_size = size_for(poor_texels_per_triangle * count, options.kind);
    const std::uint32_t holding = smallest_size(triangles, options);
    result.holding_size = holding <= max_atlas_size ? holding : 0;
    return result;
}

std::string shortage(const Capacity& c) {
    if (c.suffices()) return "";
    const std::string found = fmt::format("{:.3g} texels per triangle at {} x {}",
                                          c.texels_per_triangle, c.columns, c.rows);
    const std::string good =
        c.good_size > 0
            ? fmt::format("--size {} gives {:.0f}", c.good_size, good_texels_per_triangle)
            : fmt::format("no size gives {:.0f}", good_texels_per_triangle);
    if (!c.vertex_colours_better()) return fmt::format("{}; {}", found, good);
    const std::string least = c.least_size > 0 ? fmt::format("--size {} gives {:.0f}, ",
                                                             c.least_size, poor_texels_per_triangle)
                                               : "";
    return fmt::format("{}: a colour per vertex would show as much; {}{}", found, least, good);
}

std::string why_no_patches(const Connectivity& connectivity, const AtlasOptions& options) {
    const double each = double(options.size) * options.size /
                        double(std::max<std::uint64_t>(connectivity.shells, 1));
    if (connectivity.shells <= many_shells || each >= least_texels_per_shell) return "";
    return fmt::format("{} loose pieces would have {:.3g} texels each, too few for {}",
                       connectivity.shells, each,
                       options.kind == AtlasKind::chart ? "charts" : "patches");
}

}  // namespace burl
