// The suite `burl bench kernels`: the kernels for lattice noise side by side, by the number of
// lattice planes crossed per texel. The crossovers in procedural/field/octave_streams are taken
// from it, and it shows how far off they are.
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "app/bench/bench.h"
#include "app/bench/command.h"
#include "app/bench/noise.h"
#include "atlas/base/json.h"
#include "procedural/field/octave_streams.h"
#include "procedural/numbers/simd_target.h"

namespace burl {

namespace {

/// Times of the kernels for one noise, span length and number of crossings.
struct KernelBench {
    std::string noise;
    std::size_t span = 0;    ///< length of a span in texels
    double crossings = 0.0;  ///< lattice planes of the first octave crossed per texel
    /// Median times in ns per texel on one thread, by kernel.
    double direct = 0.0, share = 0.0, scanline = 0.0, automatic = 0.0;

    double best() const { return std::min({direct, share, scanline}); }
};

constexpr std::size_t batches = 64;

struct KernelSubject {
    std::vector<std::vector<Piece>> batches;
    StreamBuffers buffers;
    double values[batch_capacity + batch_padding] = {};
};

/// Returns successive spans in random directions, cut into batches as in a bake.
std::vector<std::vector<Piece>> random_spans(std::mt19937& random, double crossings,
                                             std::size_t span) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto vector = [&] { return Vec3d{unit(random), unit(random), unit(random)}; };
    std::vector<std::vector<Piece>> result(batches);
    Vec3d at = 30.0 * vector(), step(0.0);
    std::size_t done = span;
    for (std::vector<Piece>& pieces : result)
        for (std::size_t left = batch_capacity; left > 0;) {
            if (done == span) {
                at += double(span) * step;
                const Vec3d way = vector();
                step = crossings / (std::abs(way.x) + std::abs(way.y) + std::abs(way.z)) * way;
                done = 0;
            }
            Piece& piece = pieces.emplace_back();
            piece.solid = {at, step, double(done), std::min(left, span - done)};
            piece.length = double(span);
            left -= piece.solid.count, done += piece.solid.count;
        }
    return result;
}

KernelBench bench_kernel(const std::string& name, const std::vector<Octave>& octaves,
                         double crossings, std::size_t span, int repeats) {
    std::mt19937 random(5);
    const auto subject = std::make_shared<KernelSubject>();
    subject->batches = random_spans(random, crossings, span);
    std::vector<BenchCase> cases;
    for (const Kernel kernel : {Kernel::direct, Kernel::share, Kernel::scanline, Kernel::automatic})
        cases.push_back({name, double(batches * batch_capacity), "texel",
                         [subject, streams = OctaveStreams(octaves, kernel)] {
                             for (const std::vector<Piece>& pieces : subject->batches)
                                 streams.add(pieces, batch_capacity, subject->buffers,
                                             subject->values);
                         }});
    const std::vector<BenchRow> rows = run_paired(cases, repeats);
    return {name,
            span,
            crossings,
            rows[0].ns_per_unit(),
            rows[1].ns_per_unit(),
            rows[2].ns_per_unit(),
            rows[3].ns_per_unit()};
}

/// Measures spans of `span` texels in random directions, in `repeats` paired rounds. The time
/// includes coordinates, noise and its sum, and no colours.
std::vector<KernelBench> bench_kernels(int repeats, std::size_t span) {
    const struct {
        const char* name;
        NoiseKind kind;
        Fade fade;
        std::uint32_t octaves;
    } noises[] = {{"value linear", NoiseKind::value, Fade::linear, 1},
                  {"value smooth", NoiseKind::value, Fade::smooth, 1},
                  {"value quintic", NoiseKind::value, Fade::quintic, 1},
                  {"perlin", NoiseKind::perlin, Fade::quintic, 1},
                  {"simplex", NoiseKind::simplex, Fade::quintic, 1},
                  {"value smooth, 4 octaves", NoiseKind::value, Fade::smooth, 4},
                  {"perlin, 4 octaves", NoiseKind::perlin, Fade::quintic, 4}};
    std::vector<KernelBench> rows;
    for (const auto& [name, kind, fade, octaves] : noises)
        for (const double crossings : {1.0 / 1024, 1.0 / 256, 1.0 / 64, 1.0 / 16, 1.0 / 8, 3.0 / 16,
                                       1.0 / 4, 3.0 / 8, 1.0 / 2, 1.0, 4.0})
            rows.push_back(
                bench_kernel(name, noise_octaves(kind, fade, octaves), crossings, span, repeats));
    return rows;
}

Json kernel_json(const KernelBench& row) {
    return {{"noise", row.noise},
            {"span", row.span},
            {"crossings_per_texel", row.crossings},
            {"ns_direct", row.direct},
            {"ns_share", row.share},
            {"ns_scanline", row.scanline},
            {"ns_auto", row.automatic},
            {"auto_over_best", row.automatic / row.best()}};
}

}  // namespace

void run_kernels_bench(const BenchCommand& command) {
    const std::vector<KernelBench> rows = bench_kernels(command.repeats, command.size_or(16));
    if (!report_rows(command, rows, kernel_json)) return;
    fmt::print("{:<26} {:>6} {:>15} {:>9} {:>9} {:>9} {:>9} {:>9}\n",
               "ns per texel, " + simd_level(), "span", "crossings/texel", "direct", "share",
               "scanline", "auto", "auto/best");
    for (const KernelBench& row : rows)
        fmt::print("{:<26} {:>6} {:>15.4f} {:>9.2f} {:>9.2f} {:>9.2f} {:>9.2f} {:>9.3f}\n",
                   row.noise, row.span, row.crossings, row.direct, row.share, row.scanline,
                   row.automatic, row.automatic / row.best());
}

}  // namespace burl
