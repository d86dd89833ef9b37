#pragma once
// The part of `burl bench economy` that looks through cameras: what of a texture pictures need, and
// what is worked out for them.
#include <cstdint>
#include <string>
#include <vector>

#include "app/scene/camera.h"

namespace burl {

/// Sums over a sweep of cameras around a scene.
struct ViewBench {
    std::string scene, atlas;
    std::uint32_t size = 0, cell = 0;  ///< texels a side of the texture, and of a cell
    int views = 0;
    /// Texels that have a share in a pixel: looked up with a weight or, of direct levels, samples
    /// of one that is. Those made for them, and those of all spans of level 0.
    std::uint64_t visible = 0, made = 0, whole = 0;
    std::uint64_t read = 0;   ///< of all levels, texels that are looked up with a weight
    std::uint64_t tiles = 0;  ///< pairs of a 32 x 32 tile and a level that lookups read
    double worst = 0.0;       ///< of the views' made / visible
    double seconds_find = 0.0, seconds_make = 0.0;  ///< of all views
    double seconds_whole = 0.0;                     ///< of one whole texture, levels included

    double made_over_visible() const { return double(made) / double(visible); }
};

struct ViewBenchSubjects {
    std::uint32_t size = 1024;       ///< texels a side
    PictureSize picture{1024, 768};  ///< of 2 x 2 samples a pixel
    int views = 12;                  ///< all round, from below and above
    std::vector<std::string> samples{"king", "torus", "cad_part"};  ///< besides the teapot
};

/// Cameras around the teapot, alone and behind balls that hide parts of it, and around other
/// samples, each so near that it fills the picture; strips, quad and patch atlases. `platform` as
/// in create_gl_context, whose errors it throws.
std::vector<ViewBench> bench_views(const std::string& platform, const ViewBenchSubjects& subjects);

/// Distances of the eye from the teapot, in radii of its sphere: near, over the room, far.
inline constexpr double economy_distances[] = {3.5, 14.0, 56.0};

/// The MIP level of its texture of which the teapot shows the most texels from each of them.
std::vector<std::uint32_t> bench_levels_seen(const std::string& platform, std::uint32_t size);

}  // namespace burl
