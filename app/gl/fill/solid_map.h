#pragma once
// The solid map of an atlas (procedural/batch/point_map.h) as textures, from which a shader fills a
// mesh's atlas by itself.
#include "app/gl/fill/lattice_map.h"
#include "procedural/maps/point_map.h"

namespace burl {

/// A solid map; a texel's solid point is base + local.
class GlSolidMap {
  public:
    GlSolidMap(GlTarget target, const Vec3d& base) : target_(std::move(target)), base_(base) {}
    /// RGBA32F: x, y, z, and 1 in spans; 0 elsewhere. The error is up to 2^-25 of the solid's size.
    const GlTexture& local() const { return target_.texture(0); }
    /// R32UI: the number of the texel's map (Span::map), no_owner outside all spans.
    const GlTexture& owners() const { return target_.texture(1); }
    const Vec3d& base() const { return base_; }
    /// The target with both textures, for reading back.
    const GlTarget& target() const { return target_; }

  private:
    GlTarget target_;
    Vec3d base_;
};

/// The solid map of the texels of `tile`, with points mapped by `map`, relative to `base`
/// (solid_base). 0 threads means all. Throws Error(unsupported) for MapFill::gpu where OpenGL has
/// no float64.
GlSolidMap make_solid_map(const GladGLContext& gl, const SolidAtlas& solid, const Affine3& map,
                          const Vec3d& base, const GlTile& tile, int threads = 0,
                          MapFill fill = MapFill::automatic);

}  // namespace burl
