#pragma once
// Lobes of microfacets, which the functions of what a surface reflects and the tables of what they
// reflect altogether share. Cosines are those of unit vectors; alpha is perceptual roughness
// squared.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "atlas/base/vec.h"

namespace burl {

/// The least perceptual roughness of lobes: that of a mirror for every picture.
inline constexpr double least_roughness = 0.03;

inline double alpha_of(double roughness) {
    const double r = std::clamp(roughness, least_roughness, 1.0);
    return r * r;
}

/// Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", 1994: (1 - cosine)^5.
inline double schlick(double cosine) {
    const double m = std::clamp(1.0 - cosine, 0.0, 1.0);
    return (m * m) * (m * m) * m;
}

/// The density of microfacets at an angle to the normal: GGX (Walter, Marschner, Li, Torrance,
/// "Microfacet Models for Refraction through Rough Surfaces", 2007).
inline double ggx(double normal_half, double alpha) {
    const double a2 = alpha * alpha, c2 = normal_half * normal_half;
    const double d = c2 * (a2 - 1.0) + 1.0;
    return a2 / (std::numbers::pi * d * d);
}

/// The mean of ggx() over a round light of this angular radius, whose middle has the half vector of
/// these cosines. In slopes GGX is the stereographic image of an even sphere, of which a disc is a
/// cap; the light is a disc of slopes but at a slant, where an equal area of them is taken for it.
inline double ggx_over_disc(double normal_half, double view_half, double alpha, double radius) {
    const double a2 = alpha * alpha, c2 = normal_half * normal_half;
    // Towards the horizon, where slopes have no end, lobes are as flat as at a point.
    const double upright = std::max(normal_half, 0.5);
    const double disc2 = radius * radius / (4.0 * view_half * upright * upright * upright);
    const double beyond = a2 + (1.0 - c2) / c2 - disc2;
    const double root = std::sqrt(beyond * beyond + 4.0 * a2 * disc2);
    const double mean =
        beyond > 0.0 ? 2.0 * a2 / (root * (root + beyond)) : (root - beyond) / (2.0 * root * disc2);
    return mean / (std::numbers::pi * c2 * c2);
}

/// Smith's masking and shadowing, height-correlated, over 4 (n.l) (n.v) (Heitz, "Understanding the
/// Masking-Shadowing Function in Microfacet-Based BRDFs", 2014).
inline double visibility(double normal_light, double normal_view, double alpha) {
    const double a2 = alpha * alpha;
    const auto slant = [a2](double c) { return std::sqrt(a2 + (1.0 - a2) * c * c); };
    return 0.5 / (normal_light * slant(normal_view) + normal_view * slant(normal_light));
}

/// The share of microfacets that a view sees, Smith's G1 of GGX.
inline double masking(double normal_view, double alpha) {
    const double a2 = alpha * alpha, c = normal_view;
    return 2.0 * c / (c + std::sqrt(a2 + (1.0 - a2) * c * c));
}

/// The normal of a microfacet as often as `view` sees it, both in a frame whose z is the normal
/// (Dupuy and Benyoub, "Sampling Visible GGX Normals with Spherical Caps", 2023). `at` is in
/// [0,1)^2. Its density is masking(view.z) max(0, view.h) ggx(h.z) / view.z.
inline Vec3d visible_normal(const Vec3d& view, double alpha, const Vec2d& at) {
    const Vec3d stretched = glm::normalize(Vec3d(alpha * view.x, alpha * view.y, view.z));
    const double turn = 2.0 * std::numbers::pi * at.x;
    const double z = (1.0 - at.y) * (1.0 + stretched.z) - stretched.z;
    const double out = std::sqrt(std::clamp(1.0 - z * z, 0.0, 1.0));
    const Vec3d half = Vec3d(out * std::cos(turn), out * std::sin(turn), z) + stretched;
    return glm::normalize(Vec3d(alpha * half.x, alpha * half.y, half.z));
}

/// Alpha of sheen, whose lobe would have no width at roughness 0.
inline double sheen_alpha(double roughness) {
    const double r = std::clamp(roughness, 0.07, 1.0);
    return r * r;
}

/// The density of fibres at an angle to the normal: "Charlie" (Estevez and Kulla, "Production
/// Friendly Microfacet Sheen BRDF", 2017).
inline double charlie(double normal_half, double alpha) {
    const double sine = std::sqrt(std::max(0.0, 1.0 - normal_half * normal_half));
    return (2.0 + 1.0 / alpha) * std::pow(sine, 1.0 / alpha) / (2.0 * std::numbers::pi);
}

/// Masking and shadowing of Charlie's fibres over 4 (n.l) (n.v), by the fit of Estevez and Kulla.
inline double charlie_visibility(double normal_light, double normal_view, double alpha) {
    const double old = (1.0 - alpha) * (1.0 - alpha);
    const auto fit = [old](double smooth, double rough) {
        return old * smooth + (1.0 - old) * rough;
    };
    const double a = fit(25.3245, 21.5473), b = fit(3.32435, 3.82987), c = fit(0.16801, 0.19823),
                 d = fit(-1.27393, -1.97760), e = fit(-4.85967, -4.32054);
    const auto curve = [=](double x) { return a / (1.0 + b * std::pow(x, c)) + d * x + e; };
    const auto lambda = [&](double x) {
        return x < 0.5 ? std::exp(curve(x)) : std::exp(2.0 * curve(0.5) - curve(1.0 - x));
    };
    return 1.0 /
           ((1.0 + lambda(normal_light) + lambda(normal_view)) * 4.0 * normal_light * normal_view);
}

/// Two vectors perpendicular to the unit vector `z` and one another (Duff et al., "Building an
/// Orthonormal Basis, Revisited", 2017), and `z`.
inline Mat3d frame_about(const Vec3d& z) {
    const double sign = std::copysign(1.0, z.z), a = -1.0 / (sign + z.z), b = z.x * z.y * a;
    return {Vec3d(1.0 + sign * z.x * z.x * a, sign * b, -sign * z.x),
            Vec3d(b, sign + z.y * z.y * a, -z.y), z};
}

/// Point i of n, a power of two, of Hammersley's set in (0,1)^2: i and i with its bits reversed,
/// each in the middle of one of n intervals.
inline Vec2d hammersley(std::uint32_t i, std::uint32_t n) {
    std::uint32_t bits = i;
    bits = (bits << 16) | (bits >> 16);
    bits = ((bits & 0x00ff00ffu) << 8) | ((bits & 0xff00ff00u) >> 8);
    bits = ((bits & 0x0f0f0f0fu) << 4) | ((bits & 0xf0f0f0f0u) >> 4);
    bits = ((bits & 0x33333333u) << 2) | ((bits & 0xccccccccu) >> 2);
    bits = ((bits & 0x55555555u) << 1) | ((bits & 0xaaaaaaaau) >> 1);
    return {(double(i) + 0.5) / double(n), double(bits) * 0x1p-32 + 0.5 / double(n)};
}

}  // namespace burl
