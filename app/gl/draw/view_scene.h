#pragma once
// The scene that `burl render` would load from a baked file, built without the file and before its
// texture exists: pictures of both have the same bits.
#include "app/gl/draw/view_material.h"
#include "app/pipeline/pipeline.h"
#include "app/scene/scene.h"
#include "atlas/read/pose.h"

namespace burl {

/// The parts of the pipeline that a scene is built from. Another thread may use the pipeline
/// meanwhile as long as it keeps its atlas.
struct SceneParts {
    const Mesh* input = nullptr;        ///< the pipeline's input mesh
    const MeshAtlas* layout = nullptr;  ///< the pipeline's atlas
    std::vector<Vec3f> normals{};       ///< one per corner of the atlas's mesh
    ViewMaterial material{};
    bool bumped = false;
    double weight = 0.0;  ///< the pose's weight

    const Mesh& mesh() const { return layout->mesh(*input); }
    const Atlas& atlas() const { return layout->atlas(); }
};

/// Builds the pipeline's atlas and computes normals with this crease angle.
SceneParts scene_parts(Pipeline& pipeline, double crease_degrees);

/// The scene of a .glb of the pipeline's recipe, with textures of one texel each. With a pose of
/// the pipeline's mesh the surfaces have morph targets of the recipe's weight.
Scene baked_scene(const SceneParts& parts, const MeshPose* pose = nullptr);
/// The scene of the pipeline's atlas, with normals computed with this crease angle.
inline Scene baked_scene(Pipeline& pipeline, double crease_degrees = 40.0,
                         const MeshPose* pose = nullptr) {
    return baked_scene(scene_parts(pipeline, crease_degrees), pose);
}

/// The material of all surfaces of a baked scene, whose numbers of textures are -1 for pictures
/// that the recipe does not need.
inline const SceneMaterial& baked_material(const Scene& scene) {
    return scene.surfaces.front().material;
}

}  // namespace burl
