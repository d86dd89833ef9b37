#pragma once
// How far the normals that a viewer makes of a baked normal map are from the recipe's own: what
// `burl bake --json` says about a map.
#include <vector>

#include "app/export/export.h"
#include "app/pipeline/pipeline.h"
#include "atlas/measure/surface_points.h"
#include "procedural/fill/tangent_frame.h"

namespace burl {

/// What a viewer interpolates over the atlas's mesh, per triangle corner.
struct ViewerFrames {
    const Mesh& mesh;
    std::vector<Vec3f> normals;
    std::vector<Vec4f> tangents;

    /// As exported (app/surface/normals.h, app/surface/tangents.h).
    static ViewerFrames of(Pipeline& pipeline, double crease_degrees);

    Vec3d normal(const SurfacePoint& p) const;  ///< unit
    TangentFrame frame(const SurfacePoint& p) const;
};

/// In degrees, over points spread evenly over the surface.
struct NormalErrors {
    double mean = 0.0, percentile99 = 0.0, largest = 0.0;
    double mean_tilt = 0.0;  ///< of the exact normals against the unbumped ones: the signal
};

/// Vectors of a map as lookups read them, before they are made unit length.
Image<Vec3f> components(const NormalMap& map);
Image<Vec3f> components(const Image<RgbF>& map);

/// Bilinear lookups of `map` at about `count` points, in tangent space or in the mesh's directions.
/// The recipe must have bumps.
NormalErrors normal_errors(Pipeline& pipeline, const ViewerFrames& frames, const Image<Vec3f>& map,
                           bool tangent_space, std::size_t count);

}  // namespace burl
