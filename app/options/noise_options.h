#pragma once
// One noise as the command line describes it: a kind, its octaves and a domain warp, for points of
// one to four dimensions.
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
    double warp = 0.0;  ///< cells by which the point moves for a noise of 1

    /// --noise and what goes with it.
    void add(CLI::App& verb);
    bool given() const { return !kind_.empty(); }
    /// Throws Error(usage) for an option on the verb's line that has no say in the noise.
    void check_given(const CLI::App& verb) const;
    /// Fills `noise` and `fractal`; throws Error(usage) for what the kind cannot do.
    void resolve(std::size_t dimensions);

  private:
    std::string kind_, fade_ = "smooth", feature_ = "f1", sum_ = "fbm";
    std::vector<std::uint32_t> period_;
};

/// The options' noise at a point of N coordinates. Octave k has seed + k and the period times
/// lacunarity^k; component i of the warp is the same sum with seed + 100 (i + 1).
template <class Real, std::size_t N>
NoiseSample<Real, N> sample_noise(const NoiseOptions& options, const Point<N>& p);

}  // namespace burl
