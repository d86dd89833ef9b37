// Means of x, y, 1 - z and roughness, from which every level follows on its own. 1 - z instead of z
// keeps the digits of small spreads: 1 - r^2 = d (2 - d) - x^2 - y^2 with d = 1 - z.
#include "atlas/build/normal_levels.h"

#include <algorithm>
#include <cmath>

#include "atlas/base/each_index.h"
#include "atlas/base/vec.h"
#include "atlas/build/block_levels.h"

namespace burl {
namespace {

/// x, y and 1 - z of the unit vector along `normal`, and the roughness.
Vec4f moments_of(const RgbF& normal, float roughness) {
    const Vec3d n(normal.r, normal.g, normal.b);
    const double length = glm::length(n);
    if (!(length > 0.0)) return {0.0f, 0.0f, 0.0f, roughness};
    const Vec3d unit = n / length;
    const double across = unit.x * unit.x + unit.y * unit.y;
    const double d = unit.z > 0.0 ? across / (1.0 + unit.z) : 1.0 - unit.z;
    return {float(unit.x), float(unit.y), float(d), roughness};
}

/// The roughness of a texel of mean roughness `mean` whose mean normal has the length r, where
/// `lack` is 1 - r^2. Twice Toksvig's variance (1 - r) / r is added to alpha^2.
float widened(float mean, double r, double lack) {
    if (lack <= 0.0) return mean;
    const double alpha = double(mean) * mean, squared = alpha * alpha;
    const double variance = lack / (r * (1.0 + r));
    return float(std::min(std::sqrt(std::sqrt(squared + 2.0 * variance)), 1.0));
}

}  // namespace

Image<Vec4f> normal_moments(const Image<RgbF>& normals, const Image<float>& roughness) {
    auto moments = Image<Vec4f>::unset(normals.width(), normals.height());
    for_each_index(normals.pixels().size(), [&](std::size_t i) {
        const std::size_t x = i % normals.width(), y = i / normals.width();
        moments(x, y) = moments_of(normals(x, y), roughness(x, y));
    });
    return moments;
}

NormalLevel normal_level(const Image<Vec4f>& moments) {
    NormalLevel level{{moments.width(), moments.height()}, {moments.width(), moments.height()}};
    for_each_index(moments.pixels().size(), [&](std::size_t i) {
        const std::size_t x = i % moments.width(), y = i / moments.width();
        const Vec4d m(moments(x, y));
        const Vec3d mean(m.x, m.y, 1.0 - m.z);
        const double r = glm::length(mean);
        const double lack = m.z * (2.0 - m.z) - m.x * m.x - m.y * m.y;
        const Vec3d unit = r > 0.0 ? mean / r : Vec3d(0.0, 0.0, 1.0);
        level.normals(x, y) = {float(unit.x), float(unit.y), float(unit.z)};
        level.roughness(x, y) = r > 0.0 ? widened(float(m.w), r, lack) : 1.0f;
    });
    return level;
}

std::vector<NormalLevel> normal_levels(const MeshAtlas& atlas, const Image<RgbF>& normals,
                                       const Image<float>& roughness, std::uint32_t levels) {
    std::vector<NormalLevel> result;
    for (const Image<Vec4f>& level :
         block_levels(atlas, normal_moments(normals, roughness), levels))
        result.push_back(normal_level(level));
    return result;
}

}  // namespace burl
