#include "app/light/glints.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "app/light/cube_map.h"
#include "app/light/formulas.h"
#include "app/light/microfacets.h"

namespace burl {

namespace {

constexpr double bright = 16.0;  ///< times the mean luminance
constexpr std::size_t most_glints = 64;
constexpr std::size_t block = 4;  ///< texels a side of the greatest spot

double mean_luminance(const CubeFaces& faces) {
    double sum = 0.0;
    for (const Image<RgbF>& face : faces)
        for (const RgbF& p : face.pixels()) sum += luminance(vec_of(p));
    return sum / (6.0 * double(faces[0].pixels().size()));
}

/// The bright texels of a block.
struct Spot {
    std::size_t face, x, y;  ///< the block's first texel
    Vec3d light{0.0}, towards{0.0};
    double power = 0.0;
};

/// Calls use(x, y) for every texel of a block that is brighter than the limit.
template <class Use>
void each_bright(const Image<RgbF>& face, const Spot& spot, double limit, const Use& use) {
    for (std::size_t y = spot.y; y < std::min(spot.y + block, face.height()); ++y)
        for (std::size_t x = spot.x; x < std::min(spot.x + block, face.width()); ++x)
            if (luminance(vec_of(face(x, y))) > limit) use(x, y);
}

/// The spot of a block, of what exceeds the limit, at the middle of its power.
Spot spot_at(const CubeFaces& faces, std::size_t f, std::size_t x0, std::size_t y0, double limit) {
    const double side = double(faces[0].width());
    Spot spot{f, x0, y0};
    each_bright(faces[f], spot, limit, [&](std::size_t x, std::size_t y) {
        const Vec3d seen = cube_direction({f, Vec2d(double(x) + 0.5, double(y) + 0.5) / side});
        const double solid = 4.0 / (side * side) / std::pow(glm::length(seen), 3.0);
        const Vec3d color = vec_of(faces[f](x, y));
        const Vec3d light = solid * (1.0 - limit / luminance(color)) * color;
        spot.light += light;
        spot.power += luminance(light);
        spot.towards += luminance(light) * glm::normalize(seen);
    });
    return spot;
}

/// The spots of most power, in the order of their blocks.
std::vector<Spot> spots_of(const CubeFaces& faces, double limit) {
    std::vector<Spot> spots;
    const std::size_t side = faces[0].width();
    for (std::size_t f = 0; f < 6; ++f)
        for (std::size_t y = 0; y < side; y += block)
            for (std::size_t x = 0; x < side; x += block)
                if (const Spot spot = spot_at(faces, f, x, y, limit); spot.power > 0.0)
                    spots.push_back(spot);
    std::ranges::stable_sort(spots, std::greater<>(), &Spot::power);
    if (spots.size() > most_glints) spots.resize(most_glints);
    return spots;
}

}  // namespace

Glinting without_glints(const CubeFaces& faces) {
    Glinting result{{}, faces};
    const double limit = bright * mean_luminance(faces);
    for (const Spot& spot : spots_of(faces, limit)) {
        result.glints.push_back({Vec3f(glm::normalize(spot.towards)), Vec3f(spot.light)});
        Image<RgbF>& face = result.rest[spot.face];
        each_bright(faces[spot.face], spot, limit, [&](std::size_t x, std::size_t y) {
            const Vec3d color = vec_of(face(x, y));
            face(x, y) = rgb_of(limit / luminance(color) * color);
        });
    }
    return result;
}

GlintLobe::GlintLobe(const std::vector<Glint>& glints, double alpha)
    : glints_(glints), square_(float(alpha * alpha)) {
    // The integral of density times n.l, by midpoints in n.l's angle.
    constexpr int steps = 4096;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double angle = 0.5 * std::numbers::pi * (i + 0.5) / steps;
        sum += ggx(std::cos(0.5 * angle), alpha) * std::cos(angle) * std::sin(angle);
    }
    const double whole = sum * std::numbers::pi * std::numbers::pi / steps;
    share_ = float(alpha * alpha / (std::numbers::pi * whole));
}

Vec3f GlintLobe::operator()(const Vec3f& direction) const {
    Vec3f sum(0.0f);
    for (const Glint& glint : glints_) {
        const float cosine = glm::dot(glint.direction, direction);
        if (cosine <= 0.0f) continue;
        const float d = 1.0f + (0.5f + 0.5f * cosine) * (square_ - 1.0f);
        sum += cosine / (d * d) * glint.light;
    }
    return share_ * sum;
}

}  // namespace burl
