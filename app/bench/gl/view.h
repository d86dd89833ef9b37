#pragma once
// The part of `burl bench economy` with cameras: the texels that views of a scene need, and those
// that are synthesised for them.
#include <cstdint>
#include <string>
#include <vector>

#include "app/scene/camera.h"

namespace burl {

/// Sums over a sweep of cameras around a scene.
struct ViewBench {
    std::string scene, atlas;
    std::uint32_t size = 0, cell = 0;  ///< sides of the texture and of a cell of texels, in texels
    int views = 0;
    /// Texels that contribute to a pixel, by a weighted lookup or as a sample of a direct level's
    /// texel; texels synthesised for the views; and texels of all spans of level 0, once per view.
    std::uint64_t visible = 0, made = 0, whole = 0;
    std::uint64_t read = 0;   ///< texels of all levels that lookups read with a weight
    std::uint64_t tiles = 0;  ///< pairs of a 32 x 32 tile and a level that lookups read
    double worst = 0.0;       ///< largest made / visible of a view
    double seconds_find = 0.0, seconds_make = 0.0;  ///< sums over all views
    double seconds_whole = 0.0;  ///< time of one whole texture, MIP levels included

    double made_over_visible() const { return double(made) / double(visible); }
};

/// The scenes and views to measure.
struct ViewBenchSubjects {
    std::uint32_t size = 1024;       ///< side of the texture in texels
    PictureSize picture{1024, 768};  ///< size of the views in pixels, with 2 x 2 samples each
    int views = 12;                  ///< number of views, all round, from below and above
    std::vector<std::string> samples{"king", "torus", "cad_part"};  ///< meshes besides the teapot
};

/// Measures views of the teapot, alone and behind balls that hide parts of it, and of other
/// samples, each filling the picture, with area, quad and patch atlases. `platform` is that of
/// create_gl_context(), whose errors are thrown.
std::vector<ViewBench> bench_views(const std::string& platform, const ViewBenchSubjects& subjects);

/// Distances of the eye from the teapot in radii of its bounding sphere: near, across a room, far.
inline constexpr double economy_distances[] = {3.5, 14.0, 56.0};

/// The MIP level of which the teapot shows the most texels, for each of economy_distances.
std::vector<std::uint32_t> bench_levels_seen(const std::string& platform, std::uint32_t size);

}  // namespace burl
