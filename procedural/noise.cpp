#include "procedural/noise.h"

namespace burl {

double evaluate_noise(NoiseKind kind, Fade fade, std::uint32_t seed, const Vec3d& p) {
    if (kind == NoiseKind::perlin)
        return perlin_noise(p, [seed](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
            return lattice_gradient(i, j, k, seed);
        });
    return value_noise(p, fade, [seed](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
        return lattice_value(i, j, k, seed);
    });
}

}  // namespace burl
