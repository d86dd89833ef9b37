#pragma once
// Stratified sample points in a texel for supersampling, with the weights of pbrt's checkerboard
// (Gaussian of the distance from the centre). The points depend on the texel's coordinates alone.
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>

#include "procedural/numbers/lattice_hash.h"

namespace burl {

class SamplePattern {
  public:
    /// Cuts the texel into columns x rows = samples cells, as nearly square as that number allows,
    /// with one random sample in each.
    explicit SamplePattern(int samples) : columns_(1), rows_(samples) {
        for (int c = 1; c * c <= samples; ++c)
            if (samples % c == 0) columns_ = c, rows_ = samples / c;
    }

    int samples() const { return columns_ * rows_; }
    int columns() const { return columns_; }
    int rows() const { return rows_; }

    /// Sample i of texel (x, y): its offsets from the centre along u and v, in texels, in [-1/2,
    /// 1/2].
    std::pair<float, float> operator()(int i, std::uint32_t x, std::uint32_t y) const {
        const std::uint32_t bits = LatticeHash::bits(x, y, std::uint32_t(i), 0x5eed);
        const double jitter_u = double(bits >> 16) * 0x1p-16 + 0x1p-17;
        const double jitter_v = double(bits & 0xffff) * 0x1p-16 + 0x1p-17;
        return {float((i % columns_ + jitter_u) / columns_ - 0.5),
                float((i / columns_ + jitter_v) / rows_ - 0.5)};
    }

  private:
    int columns_, rows_;
};

/// pbrt's Gaussian weight up to a factor: exp(1/2 - 2 (u^2 + v^2)), u and v in texels, in [-1/2,
/// 1/2], to a relative error of 2e-15. It is computed by Taylor's series about the middle of the
/// exponent's range, because no two mathematical libraries share an exponential; supersample.glsl
/// has the same operations.
inline double gaussian_weight(double u, double v) {
    constexpr double factorials[] = {1.0,       1.0,        2.0,         6.0,         24.0,
                                     120.0,     720.0,      5040.0,      40320.0,     362880.0,
                                     3628800.0, 39916800.0, 479001600.0, 6227020800.0};
    const double x = 0.5 - 2.0 * (u * u + v * v);
    double sum = 0.0;
    for (std::size_t k = std::size(factorials); k-- > 0;) sum = 1.0 / factorials[k] + x * sum;
    return sum;
}

}  // namespace burl
