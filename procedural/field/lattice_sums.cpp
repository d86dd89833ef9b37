#include "procedural/field/lattice_sums.h"

#include <optional>

namespace burl {

namespace {

/// The factor r with b = r * a, exact in float64 for every coefficient; none if there is no such
/// factor.
std::optional<double> ratio_of(const Affine3& b, const Affine3& a) {
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) {
            if (a.linear[column][row] == 0.0) continue;
            const double ratio = b.linear[column][row] / a.linear[column][row];
            if (b.linear == ratio * a.linear && b.offset == ratio * a.offset) return ratio;
            return {};
        }
    return {};
}

}  // namespace

std::vector<LatticeSum> lattice_sums(std::span<const Octave> octaves) {
    std::vector<LatticeSum> sums;
    for (const Octave& octave : octaves) {
        NoiseSpec noise = octave.noise;
        noise.seed = 0;
        std::optional<double> ratio;
        if (!sums.empty() && sums.back().sum.noise == noise &&
            sums.back().sum.shape == octave.shape)
            ratio = ratio_of(octave.lattice_from_solid, sums.back().lattice);
        if (!ratio) {
            sums.push_back({octave.lattice_from_solid, {noise, octave.shape, {}, 0.0}});
            ratio = 1.0;
        }
        sums.back().sum.octaves.push_back({octave.noise.seed, *ratio, octave.scale});
    }
    return sums;
}

}  // namespace burl
