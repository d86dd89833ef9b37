#pragma once
// The scene that `burl render` would read from a baked file, before there is a texture, and without
// the detour by way of a document: a picture of the one has the bits of a picture of the other.
#include "app/pipeline/pipeline.h"
#include "app/scene/scene.h"
#include "atlas/read/pose.h"

namespace burl {

/// What a scene is made of, as far as the pipeline has to do with it: while the scene is made,
/// another thread may go on with the pipeline, which must keep its atlas.
struct SceneParts {
    const Mesh* input = nullptr;        ///< the pipeline's
    const MeshAtlas* layout = nullptr;  ///< the pipeline's
    std::vector<Vec3f> normals{};       ///< per corner of the atlas's mesh
    bool bumped = false;
    double weight = 0.0;  ///< of a pose

    const Mesh& mesh() const { return layout->mesh(*input); }
    const Atlas& atlas() const { return layout->atlas(); }
};

/// Lays out the pipeline's atlas.
SceneParts scene_parts(Pipeline& pipeline, double crease_degrees);

/// As a .glb of the pipeline's recipe that computes normals with this crease; the textures have one
/// texel each. With a pose of the pipeline's mesh its surfaces have targets, of the recipe's
/// weight.
Scene baked_scene(const SceneParts& parts, const MeshPose* pose = nullptr);
inline Scene baked_scene(Pipeline& pipeline, double crease_degrees = 40.0,
                         const MeshPose* pose = nullptr) {
    return baked_scene(scene_parts(pipeline, crease_degrees), pose);
}

/// What its surfaces show: numbers of the colours and, -1 without bumps, of the normals.
inline const SceneMaterial& baked_material(const Scene& scene) {
    return scene.surfaces.front().material;
}

}  // namespace burl
