#pragma once
// The scene that `burl render` would read from a baked file, before there is a texture, and without
// the detour by way of a document: a picture of the one has the bits of a picture of the other.
#include "app/pipeline.h"
#include "app/scene.h"
#include "atlas/mesh_pose.h"

namespace burl {

/// As a .glb of the pipeline's recipe that computes normals with this crease; the textures have one
/// texel each. With a pose of the pipeline's mesh its surfaces have targets, of the recipe's
/// weight.
Scene baked_scene(Pipeline& pipeline, double crease_degrees = 40.0, const MeshPose* pose = nullptr);

/// What its surfaces show: numbers of the colours and, -1 without bumps, of the normals.
inline const SceneMaterial& baked_material(const Scene& scene) {
    return scene.surfaces.front().material;
}

}  // namespace burl
