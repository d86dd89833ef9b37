#pragma once
// The error of normals that a viewer computes from a baked normal map, against the recipe's own;
// `burl bake --json` reports it.
#include <vector>

#include "app/export/export.h"
#include "app/pipeline/pipeline.h"
#include "atlas/measure/surface_points.h"
#include "procedural/fill/tangent_frame.h"

namespace burl {

/// The frames that a viewer interpolates over the atlas's mesh, per triangle corner (3t+k).
struct ViewerFrames {
    const Mesh& mesh;
    std::vector<Vec3f> normals;
    std::vector<Vec4f> tangents;

    /// The exported frames (app/surface/normals.h, app/surface/tangents.h).
    static ViewerFrames of(Pipeline& pipeline, double crease_degrees);

    Vec3d normal(const SurfacePoint& p) const;  ///< unit length
    TangentFrame frame(const SurfacePoint& p) const;
};

/// Angles in degrees between normals, over points spread evenly over the surface.
struct NormalErrors {
    double mean = 0.0, percentile99 = 0.0, largest = 0.0;
    double mean_tilt = 0.0;  ///< the mean angle between exact and unbumped normals: the signal
};

/// The vectors of a map as bilinear lookups read them, not normalised.
Image<Vec3f> components(const NormalMap& map);
Image<Vec3f> components(const Image<RgbF>& map);

/// The errors of bilinear lookups of `map` at about `count` points; `tangent_space` tells the map's
/// space, else object space. The recipe must have bumps.
NormalErrors normal_errors(Pipeline& pipeline, const ViewerFrames& frames, const Image<Vec3f>& map,
                           bool tangent_space, std::size_t count);

}  // namespace burl
