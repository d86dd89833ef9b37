#include "atlas/measure/surface_samples.h"

#include <algorithm>
#include <cmath>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "atlas/base/random_unit.h"

namespace burl {

namespace {

constexpr double sliver = 0.05;  // area relative to edge^2 up to which pieces stay whole
constexpr double most_pieces = 0x1p24;

double area_of(const std::array<Vec3d, 3>& p) {
    return 0.5 * glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
}

double length_of(const std::array<Vec3d, 3>& p, std::size_t k) {
    return glm::length(p[(k + 1) % 3] - p[k]);
}

std::array<Vec3d, 3> points_of(const Mesh& mesh, std::size_t t) {
    const auto& [a, b, c] = mesh.triangles[t];
    return {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
}

/// Cuts triangles into pieces, one triangle after the other.
class Cutter {
  public:
    Cutter(double edge, std::uint64_t seed, const std::function<bool(const Vec3d&)>& wanted,
           std::vector<SurfaceSample>& samples)
        : edge_(edge), seed_(seed), wanted_(wanted), samples_(samples) {}

    void cut(std::uint32_t triangle, const std::array<Vec3d, 3>& points) {
        triangle_ = triangle;
        counter_ = std::uint64_t{triangle} << 32;
        cut(points, area_of(points), 0.5 * edge_);
    }

  private:
    void cut(const std::array<Vec3d, 3>& p, double area, double enough) {
        std::size_t longest = 0;
        for (std::size_t k : {1u, 2u})
            if (length_of(p, k) > length_of(p, longest)) longest = k;
        const bool small = length_of(p, longest) <= enough;
        if (small || area <= sliver * edge_ * edge_) return keep(p, area, small);
        const Vec3d &a = p[longest], &b = p[(longest + 1) % 3], &c = p[(longest + 2) % 3];
        const double share = 0.4 + 0.2 * random();
        const Vec3d middle = a + share * (b - a);
        cut({a, middle, c}, share * area, edge_);
        cut({middle, b, c}, (1.0 - share) * area, edge_);
    }

    void keep(const std::array<Vec3d, 3>& p, double area, bool small) {
        if (!(area > 0.0)) return;
        const double root = std::sqrt(random()), v = random();
        const Vec3d w = small ? Vec3d(1.0 / 3.0) : Vec3d(1.0 - root, root * (1.0 - v), root * v);
        const Vec3d point = w.x * p[0] + w.y * p[1] + w.z * p[2];
        if (wanted_(point)) samples_.push_back({point, area, triangle_});
    }

    double random() { return random_unit(seed_, counter_++); }

    double edge_;
    std::uint64_t seed_;
    const std::function<bool(const Vec3d&)>& wanted_;
    std::vector<SurfaceSample>& samples_;
    std::uint32_t triangle_ = 0;
    std::uint64_t counter_ = 0;
};

/// The edge, lengthened where it would take more than most_pieces pieces.
double affordable(const Mesh& mesh, double edge) {
    double area = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) area += area_of(points_of(mesh, t));
    const double least = std::sqrt(area / (most_pieces * sliver));
    return std::max(edge, least);
}

}  // namespace

std::vector<SurfaceSample> sample_surface(const Mesh& mesh, double edge, std::uint64_t seed,
                                          const std::function<bool(const Vec3d&)>& wanted) {
    const double longest = affordable(mesh, edge);
    constexpr std::size_t run = 64;  // triangles
    const std::size_t runs = (mesh.triangles.size() + run - 1) / run;
    std::vector<std::vector<SurfaceSample>> parts(runs);
    tbb::parallel_for(std::size_t{0}, runs, [&](std::size_t i) {
        Cutter cutter(longest, seed, wanted, parts[i]);
        const std::size_t end = std::min(mesh.triangles.size(), (i + 1) * run);
        for (std::size_t t = i * run; t < end; ++t)
            cutter.cut(std::uint32_t(t), points_of(mesh, t));
    });
    std::vector<SurfaceSample> samples;
    for (const auto& part : parts) samples.insert(samples.end(), part.begin(), part.end());
    return samples;
}

}  // namespace burl
