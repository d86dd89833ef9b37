#pragma once
// The scene that `burl render` would read from a baked file, before there is a texture, and without
// the detour by way of a document: a picture of the one has the bits of a picture of the other.
#include "app/pipeline.h"
#include "app/scene.h"

namespace burl {

/// As a .glb of the pipeline's recipe that computes normals with this crease; the textures have one
/// texel each.
Scene baked_scene(Pipeline& pipeline, double crease_degrees = 40.0);

/// What its surfaces show: numbers of the colours and, -1 without bumps, of the normals.
inline const SceneMaterial& baked_material(const Scene& scene) {
    return scene.surfaces.front().material;
}

}  // namespace burl
