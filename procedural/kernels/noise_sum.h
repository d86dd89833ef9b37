#pragma once
// Sums of octaves of one noise at points that lie anywhere, as texture graphs need them behind
// warps and round mappings: the coordinates come as float64 arrays and are split, once for all
// octaves that double one another, into fixed-point numbers of 32 bits of cell and 32 of place, so
// that an octave's error does not grow with the distance from the origin. Vectorised as in
// texel_batch.h and with the same bits on every instruction set.
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "procedural/batch/texel_batch.h"
#include "procedural/noise/fractal_sum.h"
#include "procedural/noise/spec.h"

namespace burl {

/// Whether a vectorised kernel knows the noise; what it does not know is summed point by point.
bool has_point_kernel(const NoiseSpec& noise);

struct SumOctave {
    std::uint32_t seed = 0;
    double frequency = 1.0, weight = 1.0;
    bool operator==(const SumOctave&) const = default;
};

/// offset + sum_k weight_k shape(n_k(frequency_k p)), where n_k has octave k's seed; `noise.seed`
/// does not count. Against float64 it errs by at most 5e-7 sum_k |weight_k| (1e-6 where ridged) and
/// what coordinates in float64 lose; 8e-7 for perlin1985 and perlin2002.
struct NoiseSum {
    NoiseSpec noise;
    OctaveShape shape = OctaveShape::plain;
    std::vector<SumOctave> octaves;
    double offset = 0.0;
    bool operator==(const NoiseSum&) const = default;
};

/// Octaves [begin, end) of which each doubles the frequency of the one before: coordinates are
/// split once for all of them.
struct OctaveRun {
    std::size_t begin = 0, end = 0;
};

/// All octaves, in order.
std::vector<OctaveRun> octave_runs(std::span<const SumOctave> octaves);

/// x, y and z of points, aligned to 64 bytes and batch_padding longer than the count.
using PointArrays = std::array<const double*, 3>;

/// out[j] = the sum at point j; at most batch_capacity points.
void add_up(const NoiseSum& sum, const PointArrays& points, std::size_t count, double* out);

/// Share of octave k that a sample shows of which `kept` octaves are visible, the last one fading:
/// smoothstep(0.3, 0.7, kept - k).
inline double visible_share(double kept, std::size_t k) {
    const double u = std::clamp((kept - double(k) - 0.3) * 2.5, 0.0, 1.0);
    return u * u * (3.0 - 2.0 * u);
}

/// What of the octaves shows, point by point.
struct VisibleOctaves {
    const float* kept = nullptr;  ///< null: all of them
    double mean = 0.0;            ///< of shape(n), which stands for what does not show
};

/// Arrays of value and gradient with respect to the points, aligned and padded as the points.
struct SlopeArrays {
    float* value = nullptr;
    std::array<float*, 3> slope{};
};

/// The sum and its gradient, all in float32: besides add_up's error the value has that of rounding
/// to float32. A gradient's component errs by at most 4e-6 sum_k |weight_k frequency_k| (1e-5 where
/// ridged); at a kink it is that of one side.
void add_up_slopes(const NoiseSum& sum, const PointArrays& points, std::size_t count,
                   const VisibleOctaves& visible, const SlopeArrays& out);

}  // namespace burl
