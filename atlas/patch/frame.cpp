#include "atlas/patch/frame.h"

#include <cmath>

namespace burl {
namespace {

constexpr double steps = 1 << 24;

/// Sets the patch's points from their origins: mesh points, middles of two of them, and the
/// centroids of closed holes.
void place_vertices(Patch& patch, const Mesh& mesh) {
    const auto is_hub = [&](std::size_t v) { return patch.origins[v] == VertexOrigin{}; };
    for (std::size_t v = 0; v < patch.points.size(); ++v) {
        const VertexOrigin& origin = patch.origins[v];
        if (is_hub(v))
            patch.points[v] = Vec3d(0.0);
        else if (origin.a == origin.b)
            patch.points[v] = mesh.positions[origin.a];
        else
            patch.points[v] = 0.5 * mesh.positions[origin.a] + 0.5 * mesh.positions[origin.b];
    }
    std::vector<double> rim(patch.points.size(), 0.0);
    for (std::size_t t = 0; t < patch.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const Triangle& c = patch.triangles[t];
            if (!is_hub(c[k])) continue;
            patch.points[c[k]] += patch.points[c[(k + 1) % 3]] + patch.points[c[(k + 2) % 3]];
            rim[c[k]] += 2.0;
        }
    for (std::size_t v = 0; v < rim.size(); ++v)
        if (rim[v] > 0.0) patch.points[v] /= rim[v];
}

/// Projects a planar patch again into the rectangle round it along the map's directions. Where that
/// has no height, as for a triangle without area that only the unit frame's rounding gave some, the
/// map's places stay.
void project_anew(MappedPatch& mapped) {
    PlanarMap& plane = *mapped.planar;
    const Vec3d u = glm::normalize(plane.along_u), v = glm::normalize(plane.along_v);
    const Vec3d& first = mapped.patch.points[0];
    Vec2d low(0.0), high(0.0);
    std::vector<Vec2d> flat;
    for (const Vec3d& point : mapped.patch.points) {
        flat.emplace_back(glm::dot(point - first, u), glm::dot(point - first, v));
        low = glm::min(low, flat.back());
        high = glm::max(high, flat.back());
    }
    const Vec2d size = high - low;
    for (int axis = 0; axis < 2; ++axis) {
        if (!(size[axis] > 0.0)) continue;
        for (std::size_t i = 0; i < flat.size(); ++i)
            plane.uv[i][axis] = (flat[i][axis] - low[axis]) / size[axis];
    }
    plane.origin = first + low.x * u + low.y * v;
    plane.along_u = size.x * u;
    plane.along_v = size.y * v;
    mapped.uv = plane.uv;
}

void scale(Stretch& stretch, double side) {
    const double square = side * side;
    stretch.area *= square;
    stretch.x *= square * square;
    stretch.y *= square * square;
}

}  // namespace

Mesh in_unit_frame(const Mesh& mesh) {
    Mesh result;
    result.triangles = mesh.triangles;
    result.positions = mesh.positions;
    const Box3 box = bounding_box(mesh);
    const double side = box.longest_side();
    if (!(side > 0.0)) return result;
    for (Vec3d& p : result.positions) p = glm::floor((p - box.low) / side * steps + 0.5) / steps;
    return result;
}

void to_mesh_frame(PatchMaps& maps, const Mesh& mesh) {
    double side = bounding_box(mesh).longest_side();
    if (!(side > 0.0)) side = 1.0;
    for (MappedPatch& mapped : maps.patches) {
        place_vertices(mapped.patch, mesh);
        if (mapped.planar) {
            project_anew(mapped);
            scale(mapped.planar->stretch, side);
        }
        if (mapped.rectangle) scale(mapped.rectangle->stretch, side);
        scale(mapped.stretch, side);
    }
}

}  // namespace burl
