#pragma once
// Kernels by themselves, on one batch that stays in the first cache: what a change to one of them
// is worth before the rest of a bake hides it. Whole bakes and comparisons are `burl bench`.
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "procedural/batch/texel_piece.h"

namespace burl {

/// Coordinates, octaves and the quadric.
void register_stream_benchmarks();
/// Look-ups of colours, their codes, and the exact filters.
void register_color_benchmarks();
/// Other libraries' noises at the same number of points, where the build found them.
void register_baseline_benchmarks();
/// Lattice maps of a whole atlas for OpenGL.
void register_map_benchmarks();

/// A full batch of spans of `length` texels that cross `crossings` lattice planes a texel in the
/// solid's own cells, turned at random.
std::vector<Piece> random_spans(double crossings, std::size_t length);

/// run() per iteration, with the seconds each of a batch's texels takes.
template <class Run>
void register_batch(const std::string& name, Run run) {
    benchmark::RegisterBenchmark(name.c_str(), [run](benchmark::State& state) mutable {
        for (auto _ : state) {
            run();
            benchmark::ClobberMemory();
        }
        state.counters["texel"] = benchmark::Counter(
            double(batch_capacity),
            benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    });
}

}  // namespace burl
