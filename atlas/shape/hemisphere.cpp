#include "atlas/shape/hemisphere.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "atlas/base/random_unit.h"

namespace burl {

namespace {

constexpr std::size_t set_count = 32;

/// The golden angle pi (3 - sqrt(5)) as a unit vector.
constexpr Vec2d golden(-0.7373688780783197, 0.6754902942615238);

/// The unit vector `a` turned by the angle of the unit vector `b`.
Vec2d turned(const Vec2d& a, const Vec2d& b) {
    return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}

std::uint64_t seed_of(const Vec3d& p) {
    std::uint64_t seed = 0;
    for (int k = 0; k < 3; ++k) seed = mix_bits(seed + std::bit_cast<std::uint64_t>(p[k] + 0.0));
    return seed;
}

/// A random unit vector, by rejection (von Neumann 1951), so that it takes no function whose last
/// bit depends on the library.
Vec2d random_turn(std::uint64_t seed) {
    for (std::uint64_t k = 1; k < 64; k += 2) {
        const Vec2d v(2.0 * random_unit(seed, k) - 1.0, 2.0 * random_unit(seed, k + 1) - 1.0);
        const double square = glm::dot(v, v);
        if (square > 0.01 && square <= 1.0) return v / std::sqrt(square);
    }
    return {1.0, 0.0};
}

/// Two vectors perpendicular to `z` and one another (Duff et al., "Building an Orthonormal Basis,
/// Revisited", 2017), turned about it.
Frame frame_about(const Vec3d& z, const Vec2d& turn) {
    const double sign = std::copysign(1.0, z.z), a = -1.0 / (sign + z.z), b = z.x * z.y * a;
    const Vec3d x(1.0 + sign * z.x * z.x * a, sign * b, -sign * z.x);
    const Vec3d y(b, sign + z.y * z.y * a, -z.y);
    return {Vec3f(turn.x * x + turn.y * y), Vec3f(turn.x * y - turn.y * x), Vec3f(z)};
}

}  // namespace

Hemisphere::Hemisphere(int count) : count_(std::size_t(std::max(count, 1))) {
    for (std::size_t set = 0; set < set_count; ++set) {
        Vec2d turn(1.0, 0.0);
        for (std::size_t i = 0; i < count_; ++i, turn = turned(turn, golden)) {
            const double within = (double(set) + 0.5) / double(set_count);
            const double square = (double(i) + within) / double(count_);  // share of the disc
            sets_.push_back(Vec3f(Vec3d(std::sqrt(square) * turn, std::sqrt(1.0 - square))));
        }
    }
}

Directions Hemisphere::at(const Vec3d& position, const Vec3d& normal) const {
    const std::uint64_t seed = seed_of(position);
    const auto set = std::size_t(double(set_count) * random_unit(seed, 0));
    return {{sets_.data() + set * count_, count_}, frame_about(normal, random_turn(seed))};
}

}  // namespace burl
