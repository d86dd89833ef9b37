#include "app/surface/posed_corners.h"

#include <bit>

#include "app/base/unique_rows.h"
#include "app/surface/normals.h"
#include "app/surface/tangents.h"

namespace burl {

namespace {

/// The triangle's unit normal times its angle at corner k.
Vec3d weighted_normal(const std::array<Vec3d, 3>& corners, std::size_t k) {
    const Vec3d u = unit_or_zero(corners[(k + 1) % 3] - corners[k]);
    const Vec3d v = unit_or_zero(corners[(k + 2) % 3] - corners[k]);
    return angle_between(u, v) * unit_or_zero(glm::cross(u, v));
}

/// `v` rotated by the shortest rotation from one unit vector to the other (Rodrigues); -v for
/// opposite ones.
Vec3d turned(const Vec3d& v, const Vec3d& from, const Vec3d& to) {
    const Vec3d axis = glm::cross(from, to);
    const double cosine = glm::dot(from, to);
    if (cosine < -1.0 + 1e-12) return -v;
    const Vec3d once = glm::cross(axis, v);
    return v + once + glm::cross(axis, once) / (1.0 + cosine);
}

/// Sums over the corners that share a normal.
struct NormalSums {
    /// Sums of face normals at rest and posed, and of the pose file's normals.
    Vec3d rest{0.0}, posed{0.0}, own{0.0};
    /// The normal that the corners share at rest.
    Vec3f at_rest{0.0f};
};

Vec3f posed_normal(const NormalSums& sums) {
    const Vec3d own = unit_or_zero(sums.own);
    if (own != Vec3d(0.0)) return Vec3f(own);
    const Vec3d from = unit_or_zero(sums.rest), to = unit_or_zero(sums.posed);
    if (from == Vec3d(0.0) || to == Vec3d(0.0) || from == to) return sums.at_rest;
    return Vec3f(unit_or_zero(turned(Vec3d(sums.at_rest), from, to)));
}

std::vector<Vec3f> posed_normals(const Mesh& mesh, const MeshPose& pose, const PosedPoints& points,
                                 std::span<const Vec3f> normals) {
    UniqueRows<4> rows(mesh.positions.size());
    std::vector<NormalSums> sums;
    std::vector<std::uint32_t> row_of(normals.size());
    for (std::size_t c = 0; c < normals.size(); ++c) {
        const std::size_t t = c / 3, k = c % 3;
        const auto bits = [&](int axis) {
            return std::bit_cast<std::uint32_t>(normals[c][axis] + 0.0f);
        };
        row_of[c] = rows.insert({points.triangles[t][k], bits(0), bits(1), bits(2)});
        sums.resize(rows.rows().size());
        NormalSums& sum = sums[row_of[c]];
        const Triangle& rest = mesh.triangles[t];
        sum.at_rest = normals[c];
        sum.rest += weighted_normal(
            {mesh.positions[rest[0]], mesh.positions[rest[1]], mesh.positions[rest[2]]}, k);
        sum.posed += weighted_normal(
            {pose.positions[3 * t], pose.positions[3 * t + 1], pose.positions[3 * t + 2]}, k);
        if (!pose.normals.empty()) sum.own += unit_or_zero(Vec3d(pose.normals[c]));
    }
    std::vector<Vec3f> shared(sums.size()), result(normals.size());
    for (std::size_t s = 0; s < sums.size(); ++s) shared[s] = posed_normal(sums[s]);
    for (std::size_t c = 0; c < normals.size(); ++c) result[c] = shared[row_of[c]];
    return result;
}

}  // namespace

PosedCorners posed_corners(const Mesh& mesh, const MeshPose& pose, std::span<const Vec3f> normals,
                           std::span<const Vec2d> uvs) {
    PosedCorners corners{posed_points(mesh, pose), {}, {}};
    corners.normals = posed_normals(mesh, pose, corners.points, normals);
    if (!uvs.empty())
        corners.tangents = corner_tangents(corners.points.positions, corners.points.triangles, uvs,
                                           corners.normals);
    return corners;
}

std::vector<Vec3f> blended_normals(std::span<const Vec3f> rest, std::span<const Vec3f> posed,
                                   double weight) {
    std::vector<Vec3f> blended(rest.begin(), rest.end());
    if (weight == 0.0) return blended;
    for (std::size_t i = 0; i < rest.size(); ++i) {
        const Vec3d mean = unit_or_zero((1.0 - weight) * Vec3d(rest[i]) + weight * Vec3d(posed[i]));
        if (mean != Vec3d(0.0)) blended[i] = Vec3f(mean);
    }
    return blended;
}

}  // namespace burl
