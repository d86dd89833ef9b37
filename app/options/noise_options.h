#pragma once
// One noise from the command line: a kind, its octaves and a domain warp, for points of one to four
// dimensions.
#include <string>
#include <vector>

#include "procedural/noise/fractal_sum.h"
#include "procedural/noise/noise.h"

namespace CLI {
class App;
}

namespace burl {

struct NoiseOptions {
    NoiseSpec noise;
    FractalSum fractal;
    double warp = 0.0;  ///< the displacement, in cells, for a noise of 1

    /// Adds --noise and the options of its kinds.
    void add(CLI::App& verb);
    bool given() const { return !kind_.empty(); }
    /// Throws Error(usage) for an option on the verb's command line that has no effect on the
    /// noise.
    void check_given(const CLI::App& verb) const;
    /// Sets `noise` and `fractal` from the options, for points of this many dimensions. Throws
    /// Error(usage) for dimensions or periods that the kind does not have.
    void resolve(std::size_t dimensions);

  private:
    std::string kind_, fade_ = "smooth", feature_ = "f1", sum_ = "fbm";
    std::vector<std::uint32_t> period_;
};

/// The noise of the options at a point of N coordinates. Octave k has seed + k and the period times
/// lacunarity^k; component i of the warp is the same sum with seed + 100 (i + 1).
template <class Real, std::size_t N>
NoiseSample<Real, N> sample_noise(const NoiseOptions& options, const Point<N>& p);

}  // namespace burl
