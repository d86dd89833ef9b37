// Values are converted as glTF's reader converts them: positions and texture coordinates become
// double, normals are normalised once more.
#include "app/gl/draw/view_scene.h"

#include <optional>

#include <fmt/format.h>
#include <tbb/parallel_invoke.h>

#include "app/export/vertices.h"
#include "app/surface/normals.h"
#include "app/surface/tangents.h"
#include "atlas/base/each_index.h"
#include "atlas/base/error.h"
#include "atlas/build/mesh_atlas.h"

namespace burl {

namespace {

void resize(Surface& surface, std::size_t count, const PartVertices& like) {
    surface.positions.resize(count);
    surface.normals.resize(count);
    surface.uvs.resize(count);
    if (!like.blocks.empty()) surface.blocks.resize(count);
}

/// Sets the morph target as a file with this weight stores it.
void set_target(Surface& surface, const VertexTarget& target, double weight) {
    surface.target_share = weight;
    surface.target.positions.assign(target.positions.begin(), target.positions.end());
    surface.target.normals = target.normals;
    surface.target.tangents = target.tangents;
}

Surface surface_of(const PartVertices& vertices, const SceneMaterial& material) {
    Surface surface;
    surface.material = material;
    surface.placements.clear();
    surface.tangents = vertices.tangents;
    resize(surface, vertices.positions.size(), vertices);
    surface.triangles.resize(vertices.indices.size() / 3);
    for_each_index(vertices.positions.size(), [&](std::size_t i) {
        surface.positions[i] = Vec3d(vertices.positions[i]);
        surface.normals[i] = Vec3f(glm::normalize(Vec3d(vertices.normals[i])));
        surface.uvs[i] = {vertices.uvs[i][0], vertices.uvs[i][1]};
        if (surface.blocks.empty()) return;
        const auto& [low_u, low_v, high_u, high_v] = vertices.blocks[i];
        surface.blocks[i] = {low_u, low_v, high_u, high_v};
    });
    const std::vector<std::uint32_t>& indices = vertices.indices;
    for_each_index(surface.triangles.size(), [&](std::size_t t) {
        surface.triangles[t] = {indices[3 * t], indices[3 * t + 1], indices[3 * t + 2]};
    });
    return surface;
}

/// Adds the part with the placements that nodes can express, and a copy of it for every other
/// placement.
void add_part(Scene& scene, const Part& part, const PartVertices& vertices,
              const SceneMaterial& material, double weight) {
    const auto add = [&](const PartVertices& drawn) {
        scene.surfaces.push_back(surface_of(drawn, material));
        if (!drawn.target.positions.empty())
            set_target(scene.surfaces.back(), drawn.target, weight);
    };
    std::optional<std::size_t> own;
    for (const Mat4d& instance : part.instances) {
        if (const auto place = decompose(centred(instance, vertices))) {
            if (!own) {
                own = scene.surfaces.size();
                add(vertices);
            }
            scene.surfaces[*own].placements.push_back(matrix_of(*place));
            continue;
        }
        const PartVertices moved = placed(vertices, instance);
        add(moved);
        scene.surfaces.back().placements.push_back(matrix_of(node_of_placed(moved)));
    }
}

/// The normals of the atlas's mesh; the atlas is built in parallel unless it refines the mesh.
std::vector<Vec3f> normals_of(Pipeline& pipeline, double crease_degrees) {
    std::vector<Vec3f> normals;
    if (pipeline.recipe().atlas.kind == AtlasKind::patch)
        return corner_normals(pipeline.atlas_mesh(), crease_degrees);
    const Mesh& mesh = pipeline.mesh();
    tbb::parallel_invoke([&] { normals = corner_normals(mesh, crease_degrees); },
                         [&] { pipeline.atlas(); });
    return normals;
}

}  // namespace

SceneParts scene_parts(Pipeline& pipeline, double crease_degrees) {
    if (const AtlasOptions& atlas = pipeline.recipe().atlas; atlas.columns() != atlas.rows())
        throw Error(ExitCode::unsupported,
                    fmt::format("a texture of {} x {} texels is baked but not drawn; use --size {}",
                                atlas.columns(), atlas.rows(), atlas.size));
    SceneParts parts;
    parts.normals = normals_of(pipeline, crease_degrees);
    parts.input = &pipeline.mesh();
    parts.layout = &pipeline.mesh_atlas();
    parts.bumped = !pipeline.recipe().bump.empty();
    parts.material = view_material(pipeline.recipe());
    parts.weight = pipeline.recipe().pose.weight;
    return parts;
}

Scene baked_scene(const SceneParts& parts, const MeshPose* pose) {
    const Mesh& mesh = parts.mesh();
    const Atlas& atlas = parts.atlas();
    const std::vector<Vec3f>& normals = parts.normals;
    std::vector<Vec4f> tangents;
    if (parts.bumped)
        tangents = corner_tangents(mesh.positions, mesh.triangles, corner_uvs(atlas), normals);
    std::optional<PosedCorners> posed;
    if (pose)
        posed = posed_corners(mesh, atlas_pose(*pose, *parts.input, *parts.layout), normals,
                              parts.bumped ? corner_uvs(atlas) : std::vector<Vec2d>());
    Scene scene;
    const SceneMaterial material = add_textures(scene, atlas.options, parts.material, parts.bumped);
    for (const PartVertices& vertices :
         export_vertices(mesh, atlas, normals, tangents, posed ? &*posed : nullptr))
        add_part(scene, mesh.parts[vertices.part], vertices, material, parts.weight);
    return scene;
}

}  // namespace burl
