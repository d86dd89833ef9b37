#pragma once
// Synthesis of a normal map of the recipe's bumps: per texel the bumped normal, in the tangent
// frame that a viewer has there or in the object's space. All arithmetic is float64.
#include <cstddef>
#include <functional>
#include <span>

#include "atlas/base/image.h"
#include "atlas/mesh/mesh.h"
#include "atlas/solid/atlas.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/filter.h"
#include "procedural/fill/mask_images.h"
#include "procedural/graph/bump.h"

namespace burl {

/// The surface as a viewer shades it: per triangle corner (element 3t+k) a unit normal, and for
/// tangent-space maps a unit tangent with the bitangent's sign (fill/tangent_frame.h). Without
/// tangents the map is in object space.
struct ShadingFrames {
    const Mesh& mesh;  ///< mesh whose triangles the atlas places
    const Atlas& atlas;
    std::span<const Vec3d> positions;  ///< the mesh's points in the SolidAtlas's space
    std::span<const Vec3f> normals;    ///< normals in the SolidAtlas's space
    std::span<const Vec4f> tangents;   ///< tangents in the SolidAtlas's space
};

/// The normal map of a bump, which must not be empty. With filter `none` a texel has the normal at
/// its centre, with `supersample` the mean of normals, otherwise the normal of the height as its
/// nodes filter it over the texel. `texture_from_atlas` maps the SolidAtlas's space to the
/// texture's. Texels outside every span, and of triangles without a frame, are (0, 0, 1). `threads`
/// 0 means all; `precision`, float32 or float64, is that of sums of noise. `masks` has an image for
/// each mask that the height reads, else Error(unsupported) is thrown. Rgb8 and Rgb16 hold linear
/// codes, RgbF components from -1 to 1. `economy` has a request to stop
/// and a meter, whose task begins anew when the texels are counted; nothing is left out.
template <class Pixel>
Image<Pixel> synthesize_normals(const SolidAtlas& solid, const ShadingFrames& frames,
                                const Bump& bump, const Affine3& texture_from_atlas,
                                const Filter& filter, int threads,
                                PrecisionKind precision = PrecisionKind::float32,
                                const MaskImages& masks = {}, const Economy& economy = {});

/// Takes the next rows of a normal map, from row `first` on.
using TakeNormals = std::function<void(std::size_t first, const Image<RgbF>& rows)>;

/// Gives the map of synthesize_normals(), with the same bytes, to `take` in bands of `rows` rows
/// from the top down; the last may have fewer, and none follows where `economy` is stopped.
void synthesize_normals_in_bands(const SolidAtlas& solid, const ShadingFrames& frames,
                                 const Bump& bump, const Affine3& texture_from_atlas,
                                 const Filter& filter, int threads, PrecisionKind precision,
                                 const MaskImages& masks, const Economy& economy, std::size_t rows,
                                 const TakeNormals& take);

/// The tangent frames of an atlas's texel centres, for shaders that make normal maps. A texel has a
/// unit normal with the bitangent's sign as alpha, and a unit tangent; both are 0 outside every
/// span and where there is no frame.
struct FrameMaps {
    Image<RgbaF> normals, tangents;
};

/// The frames, which must have tangents. `threads` 0 means all.
FrameMaps frame_maps(const SolidAtlas& solid, const ShadingFrames& frames, int threads);

}  // namespace burl
