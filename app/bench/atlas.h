#pragma once
// The suite `burl bench atlas`: what every kind of atlas costs per stage and per face, on one
// thread and on all, over meshes of 1 k to 1 M faces, and how good it is, side by side.
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/bench/bench.h"
#include "atlas/solid/atlas.h"

namespace burl {

/// Medians of one stage.
struct StageBench {
    std::string stage;  ///< "connectivity", "layout", "spans"; of quad also "pairs" and "tree"
    double one_thread = 0.0, all_threads = 0.0;  ///< seconds per run
    BenchRow time{};                             ///< on one thread
    bool part_of_layout = false;                 ///< its time is in that of "layout", too
};

struct AtlasBench {
    std::string kind;
    std::size_t faces = 0;   ///< of the mesh
    std::uint32_t size = 0;  ///< N of the texture
    std::vector<StageBench> stages;
    double coverage = 0.0;
    double psnr = 0.0;         ///< level 0, dB (docs/reference/metrics.md)
    std::vector<double> rmse;  ///< [l-1] is level l, 1 to 3

    /// One of those that every kind has.
    const StageBench& stage(std::string_view name) const;
};

/// The texture that gives `faces` triangles 25 to 100 texels a pair: a power of two.
std::uint32_t bench_texture(std::size_t faces);

/// Bumpy spheres of about as many faces as asked, all kinds of atlas: `repeats` paired rounds each.
/// The lookup errors are of `points` points.
std::vector<AtlasBench> bench_atlases(std::span<const std::size_t> faces, int repeats,
                                      std::size_t points = 20000);

}  // namespace burl
