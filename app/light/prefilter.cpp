#include "app/light/prefilter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/light/cube_map.h"
#include "app/light/formulas.h"
#include "app/light/glints.h"
#include "app/light/harmonics.h"
#include "app/light/microfacets.h"
#include "app/light/padded_cube.h"
#include "atlas/base/each_index.h"

namespace burl {

namespace {

using std::numbers::pi;
constexpr std::size_t least_side = 8;  ///< of the level of roughness 1

/// Samples per texel of a level: few where lobes are narrow and texels many.
std::uint32_t samples_of(std::size_t level) {
    return std::uint32_t(64) << std::min<std::size_t>(2 * (level - 1), 5);
}

/// The map at half its sides: means by solid angle.
Image<RgbF> half_map(const Image<RgbF>& map) {
    const std::size_t height = map.height() / 2;
    Image<RgbF> half(map.width() / 2, height);
    for (std::size_t y = 0; y < height; ++y) {
        const auto sine = [&](std::size_t row) {
            return std::sin(pi * (double(row) + 0.5) / double(map.height()));
        };
        const auto upper = float(0.5 * sine(2 * y) / (sine(2 * y) + sine(2 * y + 1)));
        const float lower = 0.5f - upper;
        for (std::size_t x = 0; x < half.width(); ++x) {
            const auto mean = [&](float RgbF::*c) {
                return upper * (map(2 * x, 2 * y).*c + map(2 * x + 1, 2 * y).*c) +
                       lower * (map(2 * x, 2 * y + 1).*c + map(2 * x + 1, 2 * y + 1).*c);
            };
            half(x, y) = {mean(&RgbF::r), mean(&RgbF::g), mean(&RgbF::b)};
        }
    }
    return half;
}

/// A map no finer than a cube of this side can hold.
Environment reduced(const Environment& environment, std::size_t side) {
    Environment result = environment;
    while (result.radiance.height() > 2 * side && result.radiance.height() % 2 == 0)
        result.radiance = half_map(result.radiance);
    return result;
}

/// Faces whose texels are light(point of the cube, as a direction).
template <class Light>
CubeFaces make_faces(std::size_t side, const Light& light) {
    CubeFaces faces;
    faces.fill(Image<RgbF>(side, side));
    for_each_index(
        6 * side,
        [&](std::size_t i) {
            const std::size_t face = i / side, y = i % side;
            for (std::size_t x = 0; x < side; ++x) {
                faces[face](x, y) = rgb_of(light(face, double(x), double(y)));
            }
        },
        1);
    return faces;
}

/// The environment itself, by 2 x 2 points a texel.
CubeFaces sharp_faces(const Environment& environment, std::size_t side) {
    return make_faces(side, [&](std::size_t face, double x, double y) {
        Vec3d sum(0.0);
        for (const double dy : {0.25, 0.75})
            for (const double dx : {0.25, 0.75})
                sum += light_from(environment,
                                  cube_direction({face, Vec2d(x + dx, y + dy) / double(side)}));
        return 0.25 * sum;
    });
}

/// A direction of a lobe about +z, its share, and the level that it is looked up in.
struct LobeSample {
    Vec3f direction;
    float share;
    std::size_t level;
};

/// The level whose texels are about `size` times as large as those of level 0: bilinear lookups
/// make them larger by themselves.
std::size_t level_of(double size) {
    return std::size_t(std::max(0.0, std::round(0.5 * std::log2(size) - 0.5)));
}

/// The samples of a GGX lobe seen along the normal, more than their share of them in its long tail.
/// Each is looked up in a level whose texels are as large as the solid angle it stands for
/// (Krivanek and Colbert, "Real-time Shading with Filtered Importance Sampling", 2008).
std::vector<LobeSample> lobe_samples(double roughness, std::uint32_t count, std::size_t side) {
    const double alpha = alpha_of(roughness), a2 = alpha * alpha;
    const double texel = 4.0 * pi / (6.0 * double(side * side));
    std::vector<LobeSample> samples;
    double sum = 0.0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec2d at = hammersley(i, count);
        const double rest = (1.0 - at.y) * (1.0 - at.y), spread = 2.0 * (1.0 - at.y);
        const double c2 = rest / (1.0 + (a2 - 1.0) * (1.0 - rest));
        const double down = 2.0 * c2 - 1.0, turn = 2.0 * pi * at.x;
        if (down <= 0.0) continue;
        const double out = std::sqrt(1.0 - down * down);
        const double solid = 4.0 * spread / (count * ggx(std::sqrt(c2), alpha));
        samples.push_back({Vec3f(Vec3d(out * std::cos(turn), out * std::sin(turn), down)),
                           float(spread * down), level_of(solid / texel)});
        sum += spread * down;
    }
    for (LobeSample& sample : samples) sample.share /= float(sum);
    return samples;
}

CubeFaces blurred_faces(const std::vector<PaddedCube>& pyramid, std::size_t side,
                        const std::vector<LobeSample>& samples, const GlintLobe& glints) {
    return make_faces(side, [&](std::size_t face, double x, double y) {
        const auto frame = glm::mat3(frame_about(
            glm::normalize(cube_direction({face, Vec2d(x + 0.5, y + 0.5) / double(side)}))));
        Vec3f sum = glints(frame[2]);
        for (const LobeSample& sample : samples)
            sum += sample.share *
                   pyramid[std::min(sample.level, pyramid.size() - 1)](frame * sample.direction);
        return Vec3d(sum);
    });
}

/// The levels of half the side each, down to one texel.
std::vector<PaddedCube> pyramid_of(const CubeFaces& faces) {
    std::vector<PaddedCube> pyramid{PaddedCube(faces)};
    for (CubeFaces level = faces; level[0].width() > 1;) {
        level = halved(level);
        pyramid.emplace_back(level);
    }
    return pyramid;
}

}  // namespace

PrefilteredLight prefilter(const Environment& environment, std::size_t side) {
    const auto [sun, sky] = without_sun(environment);
    PrefilteredLight result{sun, diffuse_harmonics(sky), {sharp_faces(reduced(sky, side), side)}};
    const Glinting parts = without_glints(result.glossy[0]);
    const std::vector<PaddedCube> pyramid = pyramid_of(parts.rest);
    std::size_t levels = 1;
    while ((side >> levels) >= least_side) ++levels;
    for (std::size_t k = 1; k < levels; ++k) {
        const double roughness = double(k) / double(levels - 1);
        result.glossy.push_back(blurred_faces(pyramid, side >> k,
                                              lobe_samples(roughness, samples_of(k), side),
                                              GlintLobe(parts.glints, alpha_of(roughness))));
    }
    return result;
}

Vec3d glossy_light(const PrefilteredLight& light, const Vec3d& direction, double roughness) {
    const double last = double(light.glossy.size()) - 1.0;
    const double at = std::clamp(roughness, 0.0, 1.0) * last;
    const auto lower = std::size_t(std::min(at, last - 1.0));
    const Vec3d first = cube_lookup(light.glossy[lower], direction);
    if (light.glossy.size() == 1) return first;
    return first + (at - double(lower)) * (cube_lookup(light.glossy[lower + 1], direction) - first);
}

}  // namespace burl
