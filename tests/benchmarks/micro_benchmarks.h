#pragma once
// Micro-benchmarks of kernels on one batch that stays in the L1 cache: they show the effect of a
// change that the rest of a bake hides. Whole bakes and comparisons are measured by `burl bench`.
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "procedural/batch/texel_batch.h"

namespace burl {

/// Registers the benchmarks of coordinates, octaves and the quadric.
void register_stream_benchmarks();
/// Registers the benchmarks of colour lookups, colour codes and the exact filters.
void register_color_benchmarks();
/// Registers the noises of other libraries, at the same number of points, where the build found
/// them.
void register_baseline_benchmarks();
/// Registers the lattice maps of a whole atlas for OpenGL.
void register_map_benchmarks();

/// Returns a full batch of randomly turned spans of `length` texels that cross `crossings` lattice
/// planes per texel, in the solid's own cells.
std::vector<Piece> random_spans(double crossings, std::size_t length);

/// Registers run() as a benchmark, with the seconds per texel of a batch.
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
