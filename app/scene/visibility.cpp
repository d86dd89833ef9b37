#include "app/scene/visibility.h"

#include <algorithm>
#include <cmath>

namespace burl {

namespace {

/// The homogeneous coordinates (x w, y w, w) of a point, (x,y) in samples with y down. The unit of
/// w is the far distance, so that products of several stay in range for scenes of any size.
Vec3d homogeneous_sample(const Camera& camera, const PictureSize& samples, const Vec3d& point) {
    const Vec3d d = (point - camera.eye) / camera.far_distance;
    const double w = -glm::dot(d, camera.back);
    return {0.5 * samples.width * (w + camera.focal_x * glm::dot(d, camera.right)),
            0.5 * samples.height * (w - camera.focal_y * glm::dot(d, camera.up)), w};
}

/// The first sample whose centre is >= edge, clamped to [0, limit].
int first_sample(double edge, int limit) {
    return int(std::clamp(std::ceil(edge - 0.5), 0.0, double(limit)));
}

bool finite(const std::array<Vec3d, 3>& v) {
    const Vec3d sum = v[0] + v[1] + v[2];
    return std::isfinite(sum.x + sum.y + sum.z);
}

/// Sets the box of samples; false where it is empty. A triangle that crosses the near plane may be
/// anywhere.
bool set_bounds(ScreenTriangle& t, const std::array<Vec3d, 3>& v, double near_w,
                const PictureSize& samples) {
    const auto [w_low, w_high] = std::minmax({v[0].z, v[1].z, v[2].z});
    if (!(w_high >= near_w) || !finite(v)) return false;
    t.x_end = samples.width;
    t.y_end = samples.height;
    if (w_low < near_w) return true;
    const auto [x_low, x_high] = std::minmax({v[0].x / v[0].z, v[1].x / v[1].z, v[2].x / v[2].z});
    const auto [y_low, y_high] = std::minmax({v[0].y / v[0].z, v[1].y / v[1].z, v[2].y / v[2].z});
    // One sample more on the high side: a centre exactly on the border belongs to the box.
    t.x_begin = first_sample(x_low, samples.width);
    t.x_end = std::min(first_sample(x_high, samples.width) + 1, samples.width);
    t.y_begin = first_sample(y_low, samples.height);
    t.y_end = std::min(first_sample(y_high, samples.height) + 1, samples.height);
    return t.x_begin < t.x_end && t.y_begin < t.y_end;
}

/// Sets the edge functions; false where the triangle is seen edge-on.
bool set_edges(ScreenTriangle& t, const std::array<Vec3d, 3>& v) {
    t.edges = {glm::cross(v[1], v[2]), glm::cross(v[2], v[0]), glm::cross(v[0], v[1])};
    const double determinant = glm::dot(v[0], t.edges[0]);
    if (!(std::abs(determinant) > 0.0)) return false;
    if (determinant < 0.0) {
        for (Vec3d& edge : t.edges) edge = -edge;
    }
    t.inverse_depth = (t.edges[0] + t.edges[1] + t.edges[2]) / std::abs(determinant);
    return true;
}

/// Whether a sample with this value of an edge function is inside, or exactly on a left or top
/// edge.
bool covers(const Vec3d& edge, double value) {
    if (value != 0.0) return value > 0.0;
    return edge.x > 0.0 || (edge.x == 0.0 && edge.y > 0.0);
}

double at(const Vec3d& linear, double x, double y) {
    return linear.x * x + linear.y * y + linear.z;
}

/// Whether the sample at (x, y) is inside the triangle.
bool covers(const ScreenTriangle& t, double x, double y) {
    return covers(t.edges[0], at(t.edges[0], x, y)) && covers(t.edges[1], at(t.edges[1], x, y)) &&
           covers(t.edges[2], at(t.edges[2], x, y));
}

/// The frontmost triangle of every sample among those for which
/// is_candidate(sample, triangle, inverse depth) holds.
template <class IsCandidate>
std::vector<std::uint32_t> frontmost(std::span<const ScreenTriangle> triangles,
                                     std::span<const std::uint32_t> candidates,
                                     const Camera& camera, int width, int first_row, int rows,
                                     const IsCandidate& is_candidate) {
    const std::size_t count = std::size_t(width) * std::size_t(rows);
    std::vector<std::uint32_t> visible(count, nothing_visible);
    std::vector<double> nearest(count, 0.0);  // 1 / depth, larger is nearer
    const double limit = camera.far_distance / camera.near_distance;
    for (const std::uint32_t index : candidates) {
        const ScreenTriangle& t = triangles[index];
        const int y_end = std::min(t.y_end, first_row + rows);
        for (int j = std::max(t.y_begin, first_row); j < y_end; ++j) {
            const std::size_t row = std::size_t(j - first_row) * std::size_t(width);
            for (int i = t.x_begin; i < t.x_end; ++i) {
                const double x = i + 0.5, y = j + 0.5;
                if (!covers(t, x, y)) continue;
                const double inverse_depth = at(t.inverse_depth, x, y);
                const std::size_t sample = row + std::size_t(i);
                if (inverse_depth > limit || inverse_depth <= nearest[sample]) continue;
                if (!is_candidate(sample, index, inverse_depth)) continue;
                nearest[sample] = inverse_depth;
                visible[sample] = index;
            }
        }
    }
    return visible;
}

/// The inverse depth of each sample's triangle; below all depths where there is none.
std::vector<double> inverse_depths(std::span<const std::uint32_t> shown,
                                   std::span<const ScreenTriangle> triangles, int width,
                                   int first_row) {
    std::vector<double> depths(shown.size(), -1.0);
    for (std::size_t k = 0; k < shown.size(); ++k) {
        if (shown[k] == nothing_visible) continue;
        const int x = int(k) % width, y = first_row + int(k) / width;
        depths[k] = at(triangles[shown[k]].inverse_depth, x + 0.5, y + 0.5);
    }
    return depths;
}

}  // namespace

std::vector<ScreenTriangle> screen_triangles(const Mesh& mesh, const Camera& camera,
                                             const PictureSize& samples) {
    const double near_w = camera.near_distance / camera.far_distance;
    std::vector<ScreenTriangle> result;
    result.reserve(mesh.triangles.size());
    for (const Part& part : mesh.parts) {
        for (const Mat4d& placement : part.instances) {
            for (std::uint32_t k = 0; k < part.triangle_count; ++k) {
                ScreenTriangle t;
                t.triangle = part.first_triangle + k;
                t.placement = &placement;
                std::array<Vec3d, 3> v;
                for (std::size_t corner = 0; corner < 3; ++corner) {
                    const Vec3d& p = mesh.positions[mesh.triangles[t.triangle][corner]];
                    v[corner] =
                        homogeneous_sample(camera, samples, Vec3d(placement * Vec4d(p, 1.0)));
                }
                if (set_bounds(t, v, near_w, samples) && set_edges(t, v)) {
                    result.push_back(t);
                }
            }
        }
    }
    return result;
}

std::vector<std::uint32_t> visible_triangles(std::span<const ScreenTriangle> triangles,
                                             std::span<const std::uint32_t> candidates,
                                             const Camera& camera, int width, int first_row,
                                             int rows) {
    return frontmost(triangles, candidates, camera, width, first_row, rows,
                     [](std::size_t, std::uint32_t, double) { return true; });
}

std::vector<std::uint32_t> triangles_behind(std::span<const std::uint32_t> front,
                                            std::span<const ScreenTriangle> triangles,
                                            std::span<const std::uint32_t> candidates,
                                            const Camera& camera, int width, int first_row,
                                            int rows) {
    const std::vector<double> depths = inverse_depths(front, triangles, width, first_row);
    return frontmost(triangles, candidates, camera, width, first_row, rows,
                     [&](std::size_t sample, std::uint32_t index, double depth) {
                         return depth < depths[sample] ||
                                (depth == depths[sample] && index > front[sample]);
                     });
}

Vec3d barycentrics(const ScreenTriangle& triangle, int x, int y) {
    const Vec3d b{at(triangle.edges[0], x + 0.5, y + 0.5), at(triangle.edges[1], x + 0.5, y + 0.5),
                  at(triangle.edges[2], x + 0.5, y + 0.5)};
    return b / (b.x + b.y + b.z);
}

std::array<Vec3d, 2> barycentric_steps(const ScreenTriangle& triangle, int x, int y,
                                       const Vec3d& weights) {
    const auto& e = triangle.edges;
    const Vec3d sum = e[0] + e[1] + e[2];
    const double w = at(sum, x + 0.5, y + 0.5);
    return {(Vec3d(e[0].x, e[1].x, e[2].x) - sum.x * weights) / w,
            (Vec3d(e[0].y, e[1].y, e[2].y) - sum.y * weights) / w};
}

double depth_of(const ScreenTriangle& triangle, const Camera& camera, int x, int y) {
    return camera.far_distance / at(triangle.inverse_depth, x + 0.5, y + 0.5);
}

}  // namespace burl
