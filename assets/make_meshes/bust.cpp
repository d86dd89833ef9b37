// A bust on a foot, to judge materials by: broad curves (skull, chest), tight ones (ears, lips of
// the eyes), hollows, a flat base and a sharp edge. Ellipsoids and capsules are joined by smooth
// minima (Quilez, "Smooth minimum", 2013) and the surface is taken from a grid by surface nets
// (Gibson, "Constrained Elastic Surface Nets", 1998): a point per cell that the surface passes, at
// the mean of its crossings with the cell's edges.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "assets/make_meshes/model.h"

namespace burl {
namespace {

double smooth_min(double a, double b, double reach) {
    const double h = std::max(reach - std::abs(a - b), 0.0) / reach;
    return std::min(a, b) - 0.25 * h * h * reach;
}

double ellipsoid(const Vec3d& p, const Vec3d& centre, const Vec3d& radii) {
    const Vec3d q = (p - centre) / radii;
    const double length = glm::length(q);
    return length * (length - 1.0) / std::max(glm::length(q / radii), 1e-9);
}

double capsule(const Vec3d& p, const Vec3d& a, const Vec3d& b, double radius) {
    const double t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    return glm::length(p - a - t * (b - a)) - radius;
}

/// A drum about the y axis with edges rounded by `round`.
double drum(const Vec3d& p, double low, double high, double radius, double round) {
    const double middle = 0.5 * (low + high), half = 0.5 * (high - low);
    const double outwards = std::hypot(p.x, p.z) - radius + round;
    const double upwards = std::abs(p.y - middle) - half + round;
    return std::hypot(std::max(outwards, 0.0), std::max(upwards, 0.0)) +
           std::min(std::max(outwards, upwards), 0.0) - round;
}

/// Left and right are the same, so x counts by its amount.
double head(const Vec3d& p) {
    const Vec3d q(std::abs(p.x), p.y, p.z);
    double d = ellipsoid(q, {0, 1.66, -0.03}, {0.27, 0.32, 0.34});
    d = smooth_min(d, ellipsoid(q, {0, 1.47, 0.13}, {0.17, 0.20, 0.20}), 0.14);
    d = smooth_min(d, ellipsoid(q, {0.15, 1.53, 0.19}, {0.07, 0.06, 0.08}), 0.10);
    d = smooth_min(d, ellipsoid(q, {0, 1.335, 0.265}, {0.075, 0.05, 0.05}), 0.10);
    d = smooth_min(d, capsule(q, {0.03, 1.685, 0.325}, {0.17, 1.68, 0.25}, 0.035), 0.07);
    d = -smooth_min(-d, ellipsoid(q, {0.115, 1.61, 0.375}, {0.075, 0.055, 0.11}), 0.05);
    d = smooth_min(d, ellipsoid(q, {0.115, 1.608, 0.265}, {0.048, 0.036, 0.05}), 0.025);
    d = smooth_min(d, capsule(q, {0, 1.66, 0.33}, {0, 1.53, 0.42}, 0.032), 0.05);
    d = smooth_min(d, ellipsoid(q, {0.035, 1.515, 0.385}, {0.038, 0.028, 0.04}), 0.03);
    d = smooth_min(d, capsule(q, {0, 1.437, 0.335}, {0.065, 1.43, 0.305}, 0.020), 0.03);
    d = smooth_min(d, capsule(q, {0, 1.398, 0.330}, {0.05, 1.402, 0.305}, 0.022), 0.02);
    d = smooth_min(d, ellipsoid(q, {0.275, 1.57, -0.03}, {0.032, 0.10, 0.07}), 0.03);
    return -smooth_min(-d, ellipsoid(q, {0.31, 1.575, -0.01}, {0.022, 0.06, 0.035}), 0.02);
}

double body(const Vec3d& p) {
    const Vec3d q(std::abs(p.x), p.y, p.z);
    double d = capsule(q, {0, 1.34, 0.0}, {0, 0.98, -0.05}, 0.15);
    d = smooth_min(d, capsule(q, {0, 0.92, -0.06}, {0.42, 0.84, -0.05}, 0.15), 0.26);
    d = smooth_min(d, ellipsoid(q, {0.06, 0.68, 0.02}, {0.36, 0.30, 0.24}), 0.18);
    d = smooth_min(d, capsule(q, {0.03, 0.99, 0.07}, {0.33, 0.95, 0.04}, 0.025), 0.07);
    // Cut off below, where the bust stands on its foot.
    return std::max(d, 0.52 - p.y);
}

double bust(const Vec3d& p) {
    const double stem = drum(p, 0.06, 0.60, 0.17, 0.02);
    const double foot = drum(p, 0.0, 0.16, 0.38, 0.03);
    const double stand = smooth_min(foot, stem, 0.14);
    return std::min(smooth_min(head(p), body(p), 0.12), stand);
}

/// Samples of the bust's distance at the points of a grid.
class Grid {
  public:
    explicit Grid(double step) : step_(step) {
        for (int axis = 0; axis < 3; ++axis)
            size_[std::size_t(axis)] = int(std::ceil((high[axis] - low[axis]) / step)) + 1;
        for (int z = 0; z < size_[2]; ++z)
            for (int y = 0; y < size_[1]; ++y)
                for (int x = 0; x < size_[0]; ++x) samples_.push_back(bust(place(x, y, z)));
    }

    int size(int axis) const { return size_[std::size_t(axis)]; }
    double at(const std::array<int, 3>& i) const {
        return samples_[std::size_t((i[2] * size_[1] + i[1]) * size_[0] + i[0])];
    }
    Vec3d place(int x, int y, int z) const { return low + step_ * Vec3d(x, y, z); }

    /// The cell's point: the mean of the surface's crossings with the cell's 12 edges.
    Vec3d net_point(const std::array<int, 3>& cell) const {
        Vec3d sum(0.0);
        int count = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (int corner = 0; corner < 4; ++corner) {
                std::array<int, 3> a = cell;
                a[(axis + 1) % 3] += corner & 1;
                a[(axis + 2) % 3] += corner >> 1;
                std::array<int, 3> b = a;
                ++b[axis];
                if ((at(a) < 0.0) == (at(b) < 0.0)) continue;
                const double t = at(a) / (at(a) - at(b));
                sum += glm::mix(place(a[0], a[1], a[2]), place(b[0], b[1], b[2]), t);
                ++count;
            }
        return sum / double(std::max(count, 1));
    }

  private:
    static constexpr Vec3d low{-0.7213, -0.0507, -0.5031}, high{0.72, 2.10, 0.56};
    double step_;
    std::array<int, 3> size_{};
    std::vector<double> samples_;
};

/// Adds the quad of the four cells round the grid's edge from `a` along `axis`, if the surface
/// crosses it.
void add_crossing(Model& model, const Grid& grid, const std::array<int, 3>& a, std::size_t axis) {
    std::array<int, 3> b = a;
    ++b[axis];
    const bool inside = grid.at(a) < 0.0;
    if (inside == (grid.at(b) < 0.0)) return;
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto point = [&](int du, int dv) {
        std::array<int, 3> cell = a;
        cell[u] -= du, cell[v] -= dv;
        return grid.net_point(cell);
    };
    if (inside)
        model.quad(point(1, 1), point(0, 1), point(0, 0), point(1, 0));
    else
        model.quad(point(1, 1), point(1, 0), point(0, 0), point(0, 1));
}

}  // namespace

Model make_bust(double step) {
    const Grid grid(step);
    Model model;
    for (int z = 1; z + 1 < grid.size(2); ++z)
        for (int y = 1; y + 1 < grid.size(1); ++y)
            for (int x = 1; x + 1 < grid.size(0); ++x)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    add_crossing(model, grid, {x, y, z}, axis);
    return model;
}

}  // namespace burl
