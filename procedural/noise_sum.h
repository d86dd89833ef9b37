#pragma once
// Sums of octaves of one noise at points that lie anywhere, as texture graphs need them behind
// warps and round mappings: the coordinates come as float64 arrays and are split, once for all
// octaves that double one another, into fixed-point numbers of 32 bits of cell and 32 of place, so
// that an octave's error does not grow with the distance from the origin. Vectorised as in
// noise_kernels.h and with the same bits on every instruction set.
#include <array>
#include <cstddef>
#include <vector>

#include "procedural/fractal_sum.h"
#include "procedural/noise_kernels.h"
#include "procedural/noise_spec.h"

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

/// x, y and z of points, aligned to 64 bytes and batch_padding longer than the count.
using PointArrays = std::array<const double*, 3>;

/// out[j] = the sum at point j; at most batch_capacity points.
void add_up(const NoiseSum& sum, const PointArrays& points, std::size_t count, double* out);

}  // namespace burl
