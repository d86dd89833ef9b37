#pragma once
// Sums of octaves of one noise at arbitrary points, as texture graphs need them behind warps and
// round mappings. The coordinates come as float64 arrays and are split, once for all octaves that
// double one another, into fixed-point numbers of 32 bits of cell and 32 bits of place, so that an
// octave's error does not grow with the distance from the origin. Kernels are vectorised as in
// texel_batch.h, with the same bits on every instruction set.
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "procedural/batch/texel_batch.h"
#include "procedural/noise/fractal_sum.h"
#include "procedural/noise/spec.h"

namespace burl {

/// Whether a vectorised kernel evaluates the noise; other noises are summed point by point.
bool has_point_kernel(const NoiseSpec& noise);

/// One octave of a NoiseSum.
struct SumOctave {
    std::uint32_t seed = 0;
    double frequency = 1.0, weight = 1.0;
    bool operator==(const SumOctave&) const = default;
};

/// The sum offset + sum_k weight_k shape(n_k(frequency_k p)), where n_k has the seed of octave k;
/// `noise.seed` is ignored. Against float64 it errs by at most 5e-7 sum_k |weight_k| (1e-6 where
/// ridged; 8e-7 for perlin1985 and perlin2002), besides the rounding of coordinates in float64.
struct NoiseSum {
    NoiseSpec noise;
    OctaveShape shape = OctaveShape::plain;
    std::vector<SumOctave> octaves;
    double offset = 0.0;
    bool operator==(const NoiseSum&) const = default;
};

/// Octaves [begin, end), each of twice the frequency of the octave before: coordinates are split
/// once for all of them.
struct OctaveRun {
    std::size_t begin = 0, end = 0;
};

/// The runs that all octaves form, in order.
std::vector<OctaveRun> octave_runs(std::span<const SumOctave> octaves);

/// The arrays of x, y and z of points, aligned to 64 bytes and batch_padding longer than the count.
using PointArrays = std::array<const double*, 3>;

/// out[j] = the sum at point j, for at most batch_capacity points.
void add_up(const NoiseSum& sum, const PointArrays& points, std::size_t count, double* out);

/// The share of octave k in a sample that shows `kept` octaves, the last of them fading:
/// smoothstep(0.3, 0.7, kept - k).
inline double visible_share(double kept, std::size_t k) {
    const double u = std::clamp((kept - double(k) - 0.3) * 2.5, 0.0, 1.0);
    return u * u * (3.0 - 2.0 * u);
}

/// The number of octaves that each point shows, and what replaces the others.
struct VisibleOctaves {
    const float* kept = nullptr;  ///< one number per point; null where all octaves show
    double mean = 0.0;            ///< mean of shape(n), which replaces octaves that do not show
};

/// Arrays of value and gradient with respect to the points, aligned and padded as the points.
struct SlopeArrays {
    float* value = nullptr;
    std::array<float*, 3> slope{};
};

/// The sum and its gradient in float32. The value has add_up's error and that of rounding to
/// float32; a gradient's component errs by at most 4e-6 sum_k |weight_k frequency_k| (1e-5 where
/// ridged) and at a kink is the slope of one side.
void add_up_slopes(const NoiseSum& sum, const PointArrays& points, std::size_t count,
                   const VisibleOctaves& visible, const SlopeArrays& out);

}  // namespace burl
