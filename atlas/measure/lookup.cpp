#include "atlas/measure/lookup.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "atlas/measure/surface_mean.h"

namespace burl {

namespace {

/// Weight of a probe `x` standard deviations from the middle: a round Gaussian cut at gaussian_cut,
/// integrated across the line.
double profile(double x) {
    const double rest = std::max(0.0, gaussian_cut * gaussian_cut - x * x);
    return std::exp(-0.5 * x * x) * std::erf(std::sqrt(0.5 * rest));
}

/// Number of probes for a footprint's length over width: one for a round footprint, three or more
/// for others, as two would both lie in its tails.
int probe_count(double ratio) {
    if (ratio <= 1.0 + 1e-6) return 1;
    return int(std::clamp(std::ceil(ratio - 1e-6), 3.0, double(most_probes)));
}

Vec3d in_level(const MipChain<Vec3f>& chain, const Vec2d& at, std::size_t level) {
    const Image<Vec3f>&first = chain.levels[0], &image = chain.levels[level];
    const Vec2d scale(double(image.width()) / double(first.width()),
                      double(image.height()) / double(first.height()));
    return bilinear(image, at * scale);
}

}  // namespace

TexelFootprint texel_footprint(const Vec2d& a, const Vec2d& b) {
    // The half axes are the square roots of the eigenvalues of the covariance a a^T + b b^T.
    const double xx = a.x * a.x + b.x * b.x, yy = a.y * a.y + b.y * b.y;
    const double xy = a.x * a.y + b.x * b.y;
    const double middle = 0.5 * (xx + yy), half = std::hypot(0.5 * (xx - yy), xy);
    const double longer = std::sqrt(middle + half), angle = 0.5 * std::atan2(2.0 * xy, xx - yy);
    const double area = std::abs(a.x * b.y - a.y * b.x);
    return {longer * Vec2d(std::cos(angle), std::sin(angle)), longer > 0.0 ? area / longer : 0.0};
}

Vec2d mapped(const Mesh& mesh, const Atlas& atlas, std::uint32_t triangle, const Vec3d& vector) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    const auto& p = mesh.positions;
    const auto& corner = atlas.corners[triangle];
    const Vec3d u = p[b] - p[a], v = p[c] - p[a], normal = glm::cross(u, v);
    const double area = glm::dot(normal, normal);
    if (!(area > 0.0)) return Vec2d(0.0);
    const double along_u = glm::dot(glm::cross(vector, v), normal) / area;
    const double along_v = glm::dot(glm::cross(u, vector), normal) / area;
    return along_u * (corner[1] - corner[0]) + along_v * (corner[2] - corner[0]);
}

Vec3d trilinear(const MipChain<Vec3f>& levels, const Vec2d& at, double level) {
    const double last = double(levels.levels.size() - 1);
    const double held = std::clamp(level, 0.0, last), low = std::floor(held), t = held - low;
    const Vec3d value = in_level(levels, at, std::size_t(low));
    return t == 0.0 ? value : (1.0 - t) * value + t * in_level(levels, at, std::size_t(low) + 1);
}

Vec3d anisotropic(const MipChain<Vec3f>& levels, const Vec2d& at, const TexelFootprint& footprint) {
    const double major = glm::length(footprint.major);
    if (!(major > 0.0)) return trilinear(levels, at, 0.0);
    const double minor = std::max(footprint.minor, major / most_probes);
    const double level = std::log2(2.0 * minor);
    const int count = probe_count(major / minor);
    // Spread that the probes add to the width that each of them has by itself.
    const Vec2d line = footprint.major * std::sqrt(std::max(0.0, 1.0 - std::pow(minor / major, 2)));
    Vec3d sum(0.0);
    double total = 0.0;
    for (int k = 0; k < count; ++k) {
        const double x = gaussian_cut * ((2 * k + 1) / double(count) - 1.0), weight = profile(x);
        sum += weight * trilinear(levels, at + x * line, level);
        total += weight;
    }
    return sum / total;
}

TexelSteps ellipse_steps(const TexelSteps& steps) {
    const TexelFootprint ellipse = texel_footprint(steps.x, steps.y);
    const double longer = glm::length(ellipse.major);
    if (!(longer > 0.0)) return {};
    return {ellipse.major, (ellipse.minor / longer) * Vec2d(-ellipse.major.y, ellipse.major.x)};
}

Vec3d sampler_lookup(const MipChain<Vec3f>& levels, const Vec2d& at, const TexelSteps& steps,
                     int most) {
    const bool along_x = glm::length(steps.x) > glm::length(steps.y);
    const Vec2d& step = along_x ? steps.x : steps.y;
    const double longer = glm::length(step), shorter = glm::length(along_x ? steps.y : steps.x);
    if (!(longer > 0.0)) return trilinear(levels, at, 0.0);
    // Equal steps are no more than rounding apart.
    const double ratio = std::ceil(longer / std::max(shorter, longer * 1e-9) - 1e-6);
    const int count = int(std::min(std::max(ratio, 1.0), double(most)));
    Vec3d sum(0.0);
    for (int i = 1; i <= count; ++i)
        sum += trilinear(levels, at + (i / (count + 1.0) - 0.5) * step, std::log2(longer / count));
    return sum / double(count);
}

}  // namespace burl
