// Levels of all channels of a material against 64 x 64 samples of the surface in a texel. The
// figures (docs/reference/materials-levels.md) are the test's properties: --gtest_output=json:F.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "atlas/build/alpha_levels.h"
#include "atlas/build/block_levels.h"
#include "atlas/build/normal_levels.h"
#include "tests/atlas/support/made_atlas.h"
#include "tests/atlas/support/made_patches.h"

namespace burl {
namespace {

constexpr std::uint32_t side = 256;  ///< texels of level 0
constexpr std::uint32_t last = 6;
constexpr int samples = 64;  ///< along a texel's side
constexpr double pi = std::numbers::pi;

/// A sum of 24 waves of wavelengths from 6 to 96 texels in random directions.
class Waves {
  public:
    explicit Waves(unsigned seed) {
        std::mt19937 random(seed);
        const auto any = [&] { return double(random() >> 8) * 0x1p-24; };
        for (Wave& wave : waves_) {
            const double k = 2.0 * pi / (6.0 * std::pow(16.0, any())), turn = 2.0 * pi * any();
            wave = {k * std::cos(turn), k * std::sin(turn), 2.0 * pi * any(), k};
        }
    }
    /// A value of variance 1.
    double value(const Vec2d& p) const {
        double sum = 0.0;
        for (const Wave& w : waves_) sum += std::cos(w.x * p.x + w.y * p.y + w.phase);
        return sum * std::sqrt(2.0 / count);
    }
    /// The slopes of a height, of variance 1 together, all waves with the same.
    Vec2d slopes(const Vec2d& p) const {
        Vec2d sum(0.0);
        for (const Wave& w : waves_)
            sum -= std::sin(w.x * p.x + w.y * p.y + w.phase) / w.k * Vec2d(w.x, w.y);
        return sum * std::sqrt(2.0 / count);
    }

  private:
    static constexpr int count = 24;
    struct Wave {
        double x = 0.0, y = 0.0, phase = 0.0, k = 0.0;
    };
    std::array<Wave, count> waves_;
};

/// A surface whose channels are known everywhere; places are in texels of level 0.
struct Material {
    double slope = 0.3;      ///< root mean square of the slopes
    double roughness = 0.3;  ///< perceptual
    Waves height{1}, opacity{2}, tone{3};

    Vec3d normal(const Vec2d& p) const {
        const Vec2d s = slope * height.slopes(p);
        return glm::normalize(Vec3d(-s.x, -s.y, 1.0));
    }
    /// Premultiplied: a colour that follows the tone, soft holes.
    RgbaF color(const Vec2d& p) const {
        const double a = std::clamp(0.5 + 2.0 * opacity.value(p), 0.0, 1.0);
        const double t = 1.0 / (1.0 + std::exp(-2.0 * tone.value(p)));
        return {float(a * t), float(a * (1.0 - t)), float(a * 0.25), float(a)};
    }
    /// Islands with borders of a texel or two.
    double mask(const Vec2d& p) const {
        return std::clamp(0.5 + 1.5 * (opacity.value(p) - 0.9), 0.0, 1.0);
    }
    /// Metal or not.
    double metalness(const Vec2d& p) const { return tone.value(p) > 0.3 ? 1.0 : 0.0; }
};

template <class T, class At>
Image<T> baked(const At& at) {
    Image<T> image(side, side);
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x) image(x, y) = at(Vec2d(x + 0.5, y + 0.5));
    return image;
}

/// Calls visit(place) for the samples of a level's texel.
template <class Visit>
void sample(std::uint32_t level, std::uint32_t x, std::uint32_t y, const Visit& visit) {
    const double texel = std::ldexp(1.0, int(level));
    for (int j = 0; j < samples; ++j)
        for (int i = 0; i < samples; ++i)
            visit(texel * Vec2d(x + (i + 0.5) / samples, y + (j + 0.5) / samples));
}

/// The density over solid angles of microfacets' normals at cosine c from the texel's: GGX times c
/// (Walter et al. 2007, eq. 33), which integrates to 1 over the hemisphere.
double facets(double c, double alpha_squared) {
    if (c <= 0.0) return 0.0;
    const double d = 1.0 - (1.0 - alpha_squared) * c * c;
    return alpha_squared / (pi * d * d) * c;
}

/// The normals of microfacets that a texel's samples have together, at directions drawn from
/// `spread`, a lobe that is wider than they are.
class FacetTruth {
  public:
    FacetTruth(const std::vector<Vec3d>& normals, double alpha_squared, const Vec3d& axis,
               double spread) {
        const Vec3d side_axis = std::abs(axis.x) < 0.9 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
        const Vec3d t = glm::normalize(glm::cross(side_axis, axis)), b = glm::cross(axis, t);
        for (int j = 0; j < count; ++j)
            for (int i = 0; i < count; ++i) {
                const double u = (j + 0.5) / count, turn = 2.0 * pi * (i + 0.5 * (j % 2)) / count;
                const double c = std::sqrt((1.0 - u) / (1.0 + (spread - 1.0) * u));
                const double s = std::sqrt(1.0 - c * c);
                add(s * std::cos(turn) * t + s * std::sin(turn) * b + c * axis, facets(c, spread),
                    normals, alpha_squared);
            }
    }
    /// Half the integral of the absolute difference from a lobe: 0 where they agree, 1 where they
    /// have nothing in common.
    double distance(const Vec3d& normal, double alpha_squared) const {
        double sum = 0.0;
        for (const Direction& d : directions_)
            sum += std::abs(d.truth - facets(glm::dot(normal, d.h), alpha_squared)) / d.density;
        return 0.5 * sum / double(directions_.size());
    }
    /// The least distance of any roughness.
    double least_distance(const Vec3d& normal, double from) const {
        double best = 1.0;
        for (double a = from; a <= 1.0; a *= 1.05) best = std::min(best, distance(normal, a));
        return best;
    }

  private:
    static constexpr int count = 20;
    struct Direction {
        Vec3d h;
        double density, truth;
    };
    void add(const Vec3d& h, double density, const std::vector<Vec3d>& normals,
             double alpha_squared) {
        double sum = 0.0;
        for (const Vec3d& n : normals) sum += facets(glm::dot(n, h), alpha_squared);
        directions_.push_back({h, density, sum / double(normals.size())});
    }
    std::vector<Direction> directions_;
};

/// Distances of lobes from a level's truth, and of normals in degrees, in the mean over texels.
struct FacetErrors {
    double degrees = 0.0;
    double plain = 0.0;    ///< with the mean roughness
    double written = 0.0;  ///< with the level's roughness
    double slopes = 0.0;   ///< with alpha^2 widened by the samples' variance of slopes (LEAN)
    double fisher = 0.0;   ///< by their von Mises-Fisher concentration (Han et al. 2007)
    double best = 0.0;     ///< with the best roughness there is
};

/// The sum of the slopes' variances along both axes, which LEAN adds to alpha^2 (Olano and Baker
/// 2010, isotropic).
double slope_variance(const std::vector<Vec3d>& normals) {
    Vec2d sum(0.0);
    double squares = 0.0;
    for (const Vec3d& n : normals) {
        const Vec2d slope(n.x / n.z, n.y / n.z);
        sum += slope, squares += glm::dot(slope, slope);
    }
    const auto count = double(normals.size());
    return squares / count - glm::dot(sum, sum) / (count * count);
}

/// 2 / kappa of normals whose mean has the length r (Banerjee et al. 2005).
double fisher_width(double r) {
    return 2.0 * (1.0 - r * r) / (r * (3.0 - r * r));
}

Vec3d vector_of(const RgbF& n) {
    return {double(n.r), double(n.g), double(n.b)};
}

void add_errors(const Material& material, const NormalLevel& level, std::uint32_t number,
                std::uint32_t x, std::uint32_t y, FacetErrors& error) {
    std::vector<Vec3d> normals;
    Vec3d sum(0.0);
    sample(number, x, y, [&](const Vec2d& p) { normals.push_back(material.normal(p)); });
    for (const Vec3d& n : normals) sum += n;
    const Vec3d axis = glm::normalize(vector_of(level.normals(x, y)));
    error.degrees += std::acos(std::min(glm::dot(glm::normalize(sum), axis), 1.0)) * 180.0 / pi;
    const double plain = std::pow(material.roughness, 4.0);
    const double written = std::pow(double(level.roughness(x, y)), 4.0);
    const double length = glm::length(sum) / double(normals.size());
    const FacetTruth truth(normals, plain, axis, std::min(1.3 * written, 0.999));
    error.plain += truth.distance(axis, plain);
    error.written += truth.distance(axis, written);
    error.slopes += truth.distance(axis, std::min(plain + slope_variance(normals), 1.0));
    error.fisher += truth.distance(axis, std::min(plain + fisher_width(length), 1.0));
    error.best += truth.least_distance(axis, plain);
}

/// Calls visit(x, y) for 8 texels of a level, spread over it.
constexpr int texels = 8;
template <class Visit>
void visit_some(std::uint32_t level, const Visit& visit) {
    const std::uint32_t size = side >> level;
    for (std::uint32_t i = 0; i < texels; ++i)
        visit((i * size + i % 3) / texels % size, (i * 5 % texels) * size / texels);
}

FacetErrors errors_of(const Material& material, const NormalLevel& level, std::uint32_t number) {
    FacetErrors e;
    visit_some(number, [&](std::uint32_t x, std::uint32_t y) {
        add_errors(material, level, number, x, y, e);
    });
    for (double* sum : {&e.degrees, &e.plain, &e.written, &e.slopes, &e.fisher, &e.best})
        *sum /= texels;
    return e;
}

std::vector<NormalLevel> normals_of(const Material& material, const MeshAtlas& atlas) {
    const auto normals = baked<RgbF>([&](const Vec2d& p) {
        const Vec3d n = material.normal(p);
        return RgbF{float(n.x), float(n.y), float(n.z)};
    });
    return normal_levels(atlas, normals, Image<float>(side, side, float(material.roughness)), last);
}

TEST(MaterialLevels, FacetsAreNearTheSurfaces) {
    const MeshAtlas atlas = made::atlas_of(made::one_triangle(), AtlasKind::uniform, side);
    for (const auto& [slope, roughness] :
         {std::pair{0.1, 0.35}, {0.3, 0.35}, {0.7, 0.35}, {0.3, 0.2}, {0.3, 0.6}}) {
        const Material material{.slope = slope, .roughness = roughness};
        const std::vector<NormalLevel> levels = normals_of(material, atlas);
        double written = 0.0, best = 0.0;
        for (std::uint32_t l = 1; l <= last; ++l) {
            const FacetErrors e = errors_of(material, levels[l - 1], l);
            RecordProperty(
                fmt::format("slope_{}_roughness_{}_level_{}", int(std::lround(10 * slope)),
                            int(std::lround(100 * roughness)), l),
                fmt::format("degrees {:.2f} plain {:.3f} written {:.3f} slopes {:.3f} "
                            "fisher {:.3f} best {:.3f}",
                            e.degrees, e.plain, e.written, e.slopes, e.fisher, e.best));
            EXPECT_LT(e.degrees, 20.0 * slope / l) << l << " " << slope;
            EXPECT_LT(e.written, e.best + 0.06) << l << " " << slope << " " << roughness;
            if (l >= 3) {
                EXPECT_LT(e.written, 0.85 * e.plain) << l << " " << slope << " " << roughness;
            }
            written += e.written, best += e.best;
        }
        EXPECT_LT(written, 1.15 * best) << slope << " " << roughness;
    }
}

TEST(MaterialLevels, ColoursAndNumbersAreTheSurfacesMeans) {
    const MeshAtlas atlas = made::atlas_of(made::one_triangle(), AtlasKind::uniform, side);
    const Material material;
    const auto colors =
        block_levels(atlas, baked<RgbaF>([&](const Vec2d& p) { return material.color(p); }), last);
    const auto metal = block_levels(
        atlas, baked<float>([&](const Vec2d& p) { return float(material.metalness(p)); }), last);
    for (std::uint32_t l = 1; l <= last; ++l) {
        double of_color = 0.0, of_metal = 0.0;
        visit_some(l, [&](std::uint32_t x, std::uint32_t y) {
            Vec4d color(0.0);
            double share = 0.0;
            sample(l, x, y, [&](const Vec2d& p) {
                const RgbaF c = material.color(p);
                color += Vec4d(c.r, c.g, c.b, c.a) / double(samples * samples);
                share += material.metalness(p) / double(samples * samples);
            });
            const RgbaF& got = colors[l - 1](x, y);
            const Vec4d off = Vec4d(got.r, got.g, got.b, got.a) - color;
            of_color += glm::dot(off, off) / 4.0 / texels;
            of_metal += std::pow(double(metal[l - 1](x, y)) - share, 2.0) / texels;
        });
        RecordProperty(
            fmt::format("level_{}", l),
            fmt::format("color {:.5f} metalness {:.4f}", std::sqrt(of_color), std::sqrt(of_metal)));
        // Point samples of level 0 are 4^l samples of a texel of level l.
        EXPECT_LT(std::sqrt(of_color), 0.03 / l) << l;
        EXPECT_LT(std::sqrt(of_metal), 0.5 * std::ldexp(1.0, -int(l))) << l;
    }
}

TEST(MaterialLevels, MasksShowWhatTheSurfaceShows) {
    const MeshAtlas atlas = made::atlas_of(made::one_triangle(), AtlasKind::uniform, side);
    const Material material;
    const auto texture = baked<RgbaF>([&](const Vec2d& p) {
        const auto a = float(material.mask(p));
        return RgbaF{a, a, a, a};
    });
    double truth = 0.0;  // 4 x 4 samples a texel of level 0: 64 x 64 in one of level 4
    for (std::uint32_t y = 0; y < 4 * side; ++y)
        for (std::uint32_t x = 0; x < 4 * side; ++x)
            truth += material.mask(Vec2d(x + 0.5, y + 0.5) / 4.0) >= 0.5;
    truth /= 16.0 * side * side;
    const auto shown = [](const Image<RgbaF>& level) {
        const auto count =
            std::ranges::count_if(level.pixels(), [](const RgbaF& p) { return p.a >= 0.5f; });
        return double(count) / double(level.pixels().size());
    };
    const auto masked = masked_levels(atlas, texture, 0.5f, last);
    const auto plain = block_levels(atlas, texture, last);
    RecordProperty("surface", fmt::format("{:.4f}", truth));
    for (std::uint32_t l = 1; l <= last; ++l) {
        RecordProperty(
            fmt::format("level_{}", l),
            fmt::format("masked {:.4f} plain {:.4f}", shown(masked[l - 1]), shown(plain[l - 1])));
        const auto count = double(masked[l - 1].pixels().size());
        EXPECT_NEAR(shown(masked[l - 1]), truth, 0.005 + 0.5 / count) << l;
    }
}

}  // namespace
}  // namespace burl
