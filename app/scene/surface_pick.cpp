#include "app/scene/surface_pick.h"

#include <cmath>

#include <tbb/parallel_invoke.h>

namespace burl {

namespace {

Vec3d transformed(const Mat4d& map, const Vec3d& point) {
    return Vec3d(map * Vec4d(point, 1.0));
}

template <class At>
BoxTree tree_of(const std::vector<Triangle>& triangles, At at) {
    std::vector<BoxBounds> boxes(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (const std::uint32_t corner : triangles[t]) boxes[t].add(at(corner));
    return BoxTree(boxes);
}

/// A ray in the coordinates of Woop, Benthin and Wald: permuted and sheared so that it runs along
/// z.
class ShearedRay {
  public:
    explicit ShearedRay(const Ray& ray) : ray_(&ray) {
        const Vec3d length = glm::abs(ray.direction);
        z_ = length.x >= length.y && length.x >= length.z ? 0 : length.y >= length.z ? 1 : 2;
        x_ = (z_ + 1) % 3;
        y_ = (z_ + 2) % 3;
        shear_ = Vec3d(ray.direction[x_], ray.direction[y_], 1.0) / ray.direction[z_];
    }

    /// The barycentric coordinates and, in w, the depth.
    std::optional<Vec4d> meet(const Vec3d& a, const Vec3d& b, const Vec3d& c) const {
        const Vec3d p = sheared(a), q = sheared(b), r = sheared(c);
        const Vec3d edges(r.x * q.y - r.y * q.x, p.x * r.y - p.y * r.x, q.x * p.y - q.y * p.x);
        const bool inside = (edges.x >= 0.0 && edges.y >= 0.0 && edges.z >= 0.0) ||
                            (edges.x <= 0.0 && edges.y <= 0.0 && edges.z <= 0.0);
        const double sum = edges.x + edges.y + edges.z;
        if (!inside || !(std::abs(sum) > 0.0)) return std::nullopt;
        const Vec3d weights = edges / sum;
        return Vec4d(weights, weights.x * p.z + weights.y * q.z + weights.z * r.z);
    }

  private:
    Vec3d sheared(const Vec3d& point) const {
        const Vec3d d = point - ray_->origin;
        return {d[x_] - shear_.x * d[z_], d[y_] - shear_.y * d[z_], shear_.z * d[z_]};
    }

    const Ray* ray_;
    int x_ = 0, y_ = 1, z_ = 2;
    Vec3d shear_{0.0};
};

struct Nearest {
    Vec3d weights{0.0};
    double distance = std::numeric_limits<double>::infinity();
};

/// The point nearest to `uv` on the segment from corner i to corner j, by barycentric coordinates.
Nearest nearest_on_edge(const std::array<Vec2d, 3>& corners, int i, int j, const Vec2d& uv) {
    const Vec2d from = corners[std::size_t(i)], along = corners[std::size_t(j)] - from;
    const double squared = glm::dot(along, along);
    const double s =
        squared > 0.0 ? std::clamp(glm::dot(uv - from, along) / squared, 0.0, 1.0) : 0.0;
    Nearest nearest;
    nearest.weights[i] = 1.0 - s;
    nearest.weights[j] = s;
    nearest.distance = glm::distance(uv, from + s * along);
    return nearest;
}

/// The point nearest to `uv` in a triangle of the texture: `uv` itself where it lies inside.
Nearest nearest_in(const std::array<Vec2d, 3>& corners, const Vec2d& uv) {
    const Vec2d a = corners[0] - uv, b = corners[1] - uv, c = corners[2] - uv;
    const Vec3d edges(cross(b, c), cross(c, a), cross(a, b));
    const double sum = edges.x + edges.y + edges.z;
    const bool inside = glm::all(glm::greaterThanEqual(edges * (sum < 0.0 ? -1.0 : 1.0), Vec3d(0)));
    if (inside && std::abs(sum) > 0.0) return {edges / sum, 0.0};
    Nearest nearest;
    for (int i = 0; i < 3; ++i) {
        const Nearest on_edge = nearest_on_edge(corners, i, (i + 1) % 3, uv);
        if (on_edge.distance < nearest.distance) nearest = on_edge;
    }
    return nearest;
}

std::array<Vec2d, 3> uvs_of(const Surface& surface, std::uint32_t triangle) {
    const auto& [a, b, c] = surface.triangles[triangle];
    return {surface.uvs[a], surface.uvs[b], surface.uvs[c]};
}

template <class Values>
auto mixed(const Values& values, const Triangle& corners, const Vec3d& weights) {
    return weights.x * values[corners[0]] + weights.y * values[corners[1]] +
           weights.z * values[corners[2]];
}

/// The positions with the morph target at this weight; empty where they equal those at rest.
std::vector<Vec3d> moved_places(const Surface& surface, double share) {
    if (share == 0.0 || surface.target.positions.empty()) return {};
    std::vector<Vec3d> places = surface.positions;
    for (std::size_t i = 0; i < places.size(); ++i)
        places[i] += share * surface.target.positions[i];
    return places;
}

}  // namespace

SurfacePick::SurfacePick(std::shared_ptr<const Scene> scene, double share)
    : scene_(std::move(scene)), share_(share) {
    for (const Surface& surface : scene_->surfaces) {
        Trees trees;
        trees.moved = moved_places(surface, share);
        const std::vector<Vec3d>& at = trees.moved.empty() ? surface.positions : trees.moved;
        tbb::parallel_invoke(
            [&] {
                trees.points =
                    tree_of(surface.triangles, [&](std::uint32_t corner) { return at[corner]; });
            },
            [&] {
                if (surface.uvs.empty()) return;
                trees.uvs = tree_of(surface.triangles, [&](std::uint32_t corner) {
                    return Vec3d(surface.uvs[corner], 0.0);
                });
            });
        for (const Mat4d& placement : surface.placements)
            trees.local_from_scene.push_back(glm::inverse(placement));
        trees_.push_back(std::move(trees));
    }
}

/// The hit with the points and texture coordinates that follow from triangle, placement and
/// weights.
SurfaceHit SurfacePick::completed(SurfaceHit hit) const {
    const Surface& surface = scene_->surfaces[hit.surface];
    const Triangle& corners = surface.triangles[hit.triangle];
    const Vec3d local = mixed(places(hit.surface), corners, hit.weights);
    const Vec3d rest = mixed(surface.positions, corners, hit.weights);
    hit.point = transformed(surface.placements[hit.placement], local);
    hit.mesh_point = transformed(surface.placements.front(), rest);
    if (!surface.uvs.empty()) hit.uv = mixed(surface.uvs, corners, hit.weights);
    return hit;
}

Vec3d SurfacePick::normal(const SurfaceHit& hit) const {
    const Surface& surface = scene_->surfaces[hit.surface];
    const Triangle& t = surface.triangles[hit.triangle];
    const std::vector<Vec3d>& at = places(hit.surface);
    return Mat3d(surface.placements[hit.placement]) *
           glm::cross(at[t[1]] - at[t[0]], at[t[2]] - at[t[0]]);
}

std::optional<SurfaceHit> SurfacePick::meet(const Ray& ray) const {
    std::optional<SurfaceHit> best;
    double end = ray.end;
    for (std::uint32_t s = 0; s < trees_.size(); ++s) {
        const Surface& surface = scene_->surfaces[s];
        const std::vector<Vec3d>& at = places(s);
        for (std::uint32_t k = 0; k < trees_[s].local_from_scene.size(); ++k) {
            // The local ray's direction is not normalised, so that its t is that of the scene's
            // ray.
            const Mat4d& local_from_scene = trees_[s].local_from_scene[k];
            Ray local = ray;
            local.origin = transformed(local_from_scene, ray.origin);
            local.direction = Mat3d(local_from_scene) * ray.direction;
            const ShearedRay sheared(local);
            trees_[s].points.along(local, end, [&](std::uint32_t t) {
                const auto& [a, b, c] = surface.triangles[t];
                const auto met = sheared.meet(at[a], at[b], at[c]);
                if (!met || met->w < ray.begin || met->w > end) return;
                const bool here = best && best->surface == s && best->placement == k;
                if (best && met->w == end && !(here && t < best->triangle)) return;
                end = met->w;
                best = SurfaceHit{s, t, k, Vec3d(*met), {}, {}, {}, met->w};
            });
        }
    }
    if (best) best = completed(*best);
    return best;
}

std::optional<SurfaceHit> SurfacePick::at(const Vec2d& uv, double reach) const {
    BoxBounds box;
    box.add(Vec3d(uv - reach, 0.0));
    box.add(Vec3d(uv + reach, 0.0));
    std::optional<SurfaceHit> best;
    double distance = reach;
    for (std::uint32_t s = 0; s < trees_.size(); ++s)
        trees_[s].uvs.overlapping(box, [&](std::uint32_t t) {
            const Nearest nearest = nearest_in(uvs_of(scene_->surfaces[s], t), uv);
            const bool first = !best || (best->surface == s && t < best->triangle);
            const bool nearer = nearest.distance < distance;
            if (!nearer && !(first && nearest.distance == distance)) return;
            distance = nearest.distance;
            best = SurfaceHit{s, t, 0, nearest.weights, {}, {}, {}, 0.0};
        });
    if (best) best = completed(*best);
    return best;
}

}  // namespace burl
