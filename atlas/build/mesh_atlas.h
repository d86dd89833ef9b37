#pragma once
// An atlas of whichever kind was asked for, with the mesh its corners belong to: the patch atlas
// splits a few triangles, the other kinds take the mesh as it is.
#include <variant>

#include "atlas/patch/atlas.h"

namespace burl {

struct MeshPose;  // atlas/read/pose.h

/// An atlas of any kind.
class MeshAtlas {
  public:
    explicit MeshAtlas(Atlas atlas) : form_(std::move(atlas)) {}
    explicit MeshAtlas(PatchAtlas patches) : form_(std::move(patches)) {}

    /// Corners, charts and layout; those of a patch atlas are of its refined mesh, without blocks.
    const Atlas& atlas() const;
    /// The patch atlas; null for the kinds made of blocks.
    const PatchAtlas* patches() const { return std::get_if<PatchAtlas>(&form_); }
    /// The mesh whose triangles the atlas places, given the one it was built from.
    const Mesh& mesh(const Mesh& input) const;

  private:
    std::variant<Atlas, PatchAtlas> form_;
};

/// Builds an atlas of the mesh, as layout_atlas() does for strips and quad, and layout_uvs() for
/// uv. Where patches do not fit, or the mesh is mostly loose pieces (capacity.h), pairs take their
/// place: `quad`, in the largest square with a power of two in the texture's corner, or `area`
/// where that square is less than half the texture and strips fit. atlas().options.kind says which,
/// atlas().notes.fallback why. Never fails for `patch`, whatever the size.
MeshAtlas build_atlas(const Mesh& mesh, const Connectivity& connectivity,
                      const AtlasOptions& options);
/// Builds an atlas like the overload without `stop`; nothing if `stop` was requested first, which
/// only the patch layout looks for.
std::optional<MeshAtlas> build_atlas(const Mesh& mesh, const Connectivity& connectivity,
                                     const AtlasOptions& options, const std::stop_token& stop);

/// The solid points of all texels; `positions` are those of atlas.mesh(input) in the space wanted.
SolidAtlas rasterize(const Mesh& input, const MeshAtlas& atlas, std::span<const Vec3d> positions);

/// The two corners (3t+k) of an input mesh half-way between which a corner of a refined triangle
/// lies; equal where it is a corner of the input.
struct CornerOrigin {
    std::uint32_t a = 0, b = 0;
};

/// The origin of each corner of the triangles that the atlas places, in the mesh it was built from.
std::vector<CornerOrigin> corner_origins(const Mesh& input, const MeshAtlas& atlas);

/// The pose of the mesh whose triangles the atlas places, made of the pose of the mesh that the
/// atlas was built for: the middles that a patch atlas puts on edges are the middles of the posed
/// edges. Throws Error as check_pose() does.
MeshPose atlas_pose(const MeshPose& pose, const Mesh& input, const MeshAtlas& atlas);

}  // namespace burl
