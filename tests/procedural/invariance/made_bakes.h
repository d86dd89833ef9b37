#pragma once
// Small bakes of changed meshes, stage by stage: places, solid points, texture and levels.
#include <cstring>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "atlas/build/block_levels.h"
#include "atlas/build/mesh_atlas.h"
#include "atlas/measure/atlas_measures.h"
#include "atlas/measure/surface_points.h"
#include "procedural/fill/synthesize.h"
#include "tests/atlas/support/made_patches.h"

namespace burl::test {

/// Whether both vectors have the same length and the same bytes; T has no padding.
template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// The mesh with texture coordinates of its own: every triangle in a cell of a square grid.
inline Mesh with_own_places(Mesh mesh) {
    const auto side = std::uint32_t(std::ceil(std::sqrt(double(mesh.triangles.size()))));
    mesh.corners.uvs.clear();
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const Vec2d low(t % side, t / side);
        for (const Vec2d& q : {Vec2d(0.1, 0.1), Vec2d(0.9, 0.1), Vec2d(0.1, 0.9)})
            mesh.corners.uvs.push_back((low + q) / double(side));
    }
    return mesh;
}

/// A quadric and two sums of noise, in two colours.
inline Texture marble_with_perlin() {
    Texture texture;
    texture.quadric.i = 0.5;
    NoiseTerm value, perlin;
    value.amplitude = 0.5, value.frequency = Vec3d(5.0), value.octaves = 4;
    perlin.kind = NoiseKind::perlin, perlin.seed = 3;
    perlin.amplitude = 0.25, perlin.frequency = Vec3d(9.0), perlin.octaves = 2;
    texture.noise = {value, perlin};
    texture.colors.stops = {{0.0, {244, 239, 230}}, {1.0, {59, 58, 64}}};
    return texture;
}

/// A bake with all that its stages gave.
struct MadeBake {
    Mesh mesh;
    MeshAtlas atlas;
    SolidAtlas solid;
    Image<Rgb8> texture;
    std::vector<Image<RgbF>> levels;
};

/// The bake of the mesh on an atlas of that kind and a texture of 128 x 128, on all threads of the
/// caller's arena. The texture is that of the points in their unit box, or of texture_from_mesh(p)
/// where that is given.
inline MadeBake made_bake(const Mesh& mesh, AtlasKind kind,
                          const Affine3* texture_from_mesh = nullptr) {
    MeshAtlas atlas =
        build_atlas(mesh, build_connectivity(mesh), {.kind = kind, .size = 128, .tries = 2});
    const Mesh& placed = atlas.mesh(mesh);
    const Affine3 unit = solid_from_mesh(placed, SolidSpace::unit);
    const auto points = map_positions(placed, texture_from_mesh ? *texture_from_mesh : unit);
    SolidAtlas solid = rasterize(mesh, atlas, points);
    const Affine3 same{Mat3d(1.0), Vec3d(0.0)};
    auto texture = synthesize_model<Rgb8>(solid, marble_with_perlin(), same, 0);
    auto levels =
        block_levels(atlas, synthesize_model<RgbF>(solid, marble_with_perlin(), same, 0), 3);
    return {mesh, std::move(atlas), std::move(solid), std::move(texture), std::move(levels)};
}

/// The point that each texel shows, in unit space; NaN where it shows nothing.
inline std::vector<Vec3d> shown_points(const SolidAtlas& solid) {
    std::vector<Vec3d> points(std::size_t(solid.size) * solid.size, Vec3d(std::nan("")));
    for (std::size_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y))
            for (std::size_t x = span.x; x < span.x + span.count; ++x)
                points[y * solid.size + x] = solid.maps[span.map](std::int64_t(x), std::int64_t(y));
    return points;
}

/// Places in the texture of points of the surface of `bake.mesh`.
inline std::vector<Vec2d> shown_places(const MadeBake& bake, const std::vector<SurfacePoint>& at) {
    std::vector<Vec2d> places;
    for (const SurfacePoint& p : refined_points(bake.mesh, bake.atlas, at))
        places.push_back(place(bake.atlas.atlas(), p));
    return places;
}

/// The mesh with its triangles in another order, its points numbered by first use as readers do.
/// `from`, if any, becomes the old number of each new triangle.
inline Mesh with_faces_in_another_order(const Mesh& mesh, std::uint32_t seed,
                                        std::vector<std::uint32_t>* from = nullptr) {
    std::vector<std::uint32_t> order(mesh.triangles.size());
    std::iota(order.begin(), order.end(), 0u);
    std::mt19937 random(seed);
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    std::vector<std::uint32_t> number(mesh.positions.size(), ~0u);
    Mesh changed = mesh;
    changed.positions.clear(), changed.triangles.clear(), changed.corners.uvs.clear();
    for (const std::uint32_t t : order) {
        Triangle& triangle = changed.triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            std::uint32_t& n = number[mesh.triangles[t][k]];
            if (n == ~0u) {
                n = std::uint32_t(changed.positions.size());
                changed.positions.push_back(mesh.positions[mesh.triangles[t][k]]);
            }
            triangle[k] = n;
            if (!mesh.corners.uvs.empty())
                changed.corners.uvs.push_back(mesh.corners.uvs[3 * t + k]);
        }
    }
    if (from) *from = order;
    return changed;
}

/// The mesh with every point p at linear * p + shift.
inline Mesh mapped_mesh(Mesh mesh, const Mat3d& linear, const Vec3d& shift) {
    for (Vec3d& p : mesh.positions) p = linear * p + shift;
    return mesh;
}

}  // namespace burl::test
