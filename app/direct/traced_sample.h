#pragma once
// What a point of a mesh or plane sends to an eye in an environment, through surfaces that
// transmit, too.
#include "app/direct/mesh_sample.h"
#include "app/direct/render.h"

namespace burl {

/// A look at the scene: from where, with which directions, and through how many surfaces.
struct Look {
    Vec3d eye{0.0};
    LightDraw draw{};
    int depth = 0;
};

/// The mesh's light at a sample of a triangle in a placement, premultiplied by alpha.
Vec4d traced(const DirectScene& scene, const ScreenTriangle& t, const MeshSample& sample,
             const Look& look);

/// A plane's light at a point over a footprint, premultiplied by alpha.
Vec4d traced(const DirectScene& scene, const PlaneLayer& layer, const Vec3d& point,
             const Footprint& covered, const Look& look);

}  // namespace burl
