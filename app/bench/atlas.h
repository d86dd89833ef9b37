#pragma once
// The suite `burl bench atlas`: time per stage and per face of every kind of atlas, on one thread
// and on all, over meshes of 1 k to 1 M faces, and the quality of the atlases side by side.
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/bench/bench.h"
#include "atlas/measure/lookup_errors.h"
#include "atlas/solid/atlas.h"

namespace burl {

/// Median times of one stage.
struct StageBench {
    /// "connectivity", "layout", "spans"; for quad atlases also "pairs" and "tree".
    std::string stage;
    double one_thread = 0.0, all_threads = 0.0;  ///< seconds per run
    BenchRow time{};                             ///< times on one thread
    bool part_of_layout = false;  ///< whether its time is included in that of "layout"
};

/// The results of one kind of atlas on one mesh.
struct AtlasBench {
    std::string kind;
    std::size_t faces = 0;   ///< triangles of the mesh
    std::uint32_t size = 0;  ///< side N of the texture in texels
    std::vector<StageBench> stages;
    double coverage = 0.0;
    double psnr = 0.0;         ///< PSNR of lookups at level 0 in dB (docs/reference/metrics.md)
    std::vector<double> rmse;  ///< RMS error of lookups at levels 1 to 3; [l-1] is level l
    std::vector<ViewError> views{};  ///< errors of sampled views

    /// The stage of that name, which must be one that every kind has.
    const StageBench& stage(std::string_view name) const;
};

/// The side of a texture, a power of two, in which a pair of `faces` triangles has 25 to 100
/// texels.
std::uint32_t bench_texture(std::size_t faces);

/// Measures all kinds of atlas on bumpy spheres of about the given numbers of faces, with `repeats`
/// paired rounds each; lookup errors are measured at `points` points.
std::vector<AtlasBench> bench_atlases(std::span<const std::size_t> faces, int repeats,
                                      std::size_t points = 20000);

}  // namespace burl
