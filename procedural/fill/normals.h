#pragma once
// Fills an atlas with a normal map of the recipe's bumps: per texel the bumped normal, in the frame
// that a viewer will have there or in the object's space. All in float64.
#include <span>

#include "atlas/base/image.h"
#include "atlas/mesh/mesh.h"
#include "atlas/solid/atlas.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/filter.h"
#include "procedural/graph/bump.h"

namespace burl {

/// The surface as a viewer shades it: per triangle corner (3t+k) a unit normal, and for
/// tangent-space maps a unit tangent with the bitangent's sign (procedural/fill/tangent_frame.h);
/// empty tangents: a map in object space.
struct ShadingFrames {
    const Mesh& mesh;  ///< whose triangles the atlas places
    const Atlas& atlas;
    std::span<const Vec3d> positions;  ///< its points in the SolidAtlas's space
    std::span<const Vec3f> normals;    ///< in directions of that space, as the tangents
    std::span<const Vec4f> tangents;
};

/// What the texels are filtered from: with filter `none` the normal at their centre, with
/// `supersample` the mean of normals, else that of the height as its nodes filter it over the
/// texel. `texture_from_atlas` as in synthesize_graph.h; bump must not be empty. Texels outside
/// every span, and those of triangles without a frame, are (0, 0, 1). `threads` 0 means all.
/// For Rgb8 and Rgb16, linear codes, and RgbF, components from -1 to 1.
template <class Pixel>
Image<Pixel> synthesize_normals(const SolidAtlas& solid, const ShadingFrames& frames,
                                const Bump& bump, const Affine3& texture_from_atlas,
                                const Filter& filter, int threads);

}  // namespace burl
