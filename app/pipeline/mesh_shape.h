#pragma once
// A mesh's masks as images over the texels of its atlas: what graphs read
// (procedural/graph/masks.h) from the shape (atlas/shape).
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "app/recipe/recipe.h"
#include "atlas/solid/texel_field.h"
#include "atlas/solid/texel_owners.h"
#include "procedural/fill/mask_images.h"

namespace burl {

class ShapeScene;  // atlas/shape/shape_scene.h

/// All that a mask's image depends on besides the atlas. Lengths among the mask's numbers are in
/// the SolidAtlas's space.
struct TexelMaskKey {
    GraphMask mask;
    double factor = 1.0;                 ///< of the values, which are lengths where it is not 1
    std::uint32_t size = 0;              ///< side of the image in texels
    std::vector<PaintStroke> strokes{};  ///< of the layer that a mask `paint` shows
    bool operator==(const TexelMaskKey&) const = default;
};

/// The key of a mask of the recipe's graph, whose lengths are in units of the graph's solid point:
/// those of the SolidAtlas's space times the recipe's scale.
TexelMaskKey mask_key(const GraphMask& mask, const Recipe& recipe, std::uint32_t size);

/// A mesh prepared for masks. It keeps a copy of the mesh.
class MeshShape {
  public:
    /// `solid_from_mesh` maps the mesh's coordinates to the SolidAtlas's space: a scale and a
    /// shift.
    MeshShape(Mesh mesh, const Affine3& solid_from_mesh);
    ~MeshShape();

    /// The mask, which is none of paint, at all texels of an atlas of the mesh, 0 for texels that
    /// show nothing, with its gradients if `slopes`. Occlusion, the sky's light, thickness and
    /// curvature are interpolated between points at most about four texels apart where they are
    /// smooth; all others are the mask at the texel's point. Once `stop` is requested the result
    /// must not be used.
    TexelField image(const SolidAtlas& solid, const TexelOwners& owners, const TexelMaskKey& key,
                     bool slopes, const std::stop_token& stop = {}) const;

    /// The mask, with its gradients, at the points of the mesh that are nearest to `positions`,
    /// both in the SolidAtlas's space. Gradients without a closed form are differences over a 256th
    /// of the box's diagonal, about what four texels of a texture of 1024 x 1024 are.
    std::vector<Dual> at(std::span<const Vec3d> positions, const TexelMaskKey& key) const;

  private:
    /// Light sees the normals that the mesh is drawn with: computed ones where it has none.
    TexelField light(const SolidAtlas& solid, const TexelOwners& owners, const GraphMask& mask,
                     bool slopes, const std::stop_token& stop) const;

    Mesh mesh_;  ///< in the SolidAtlas's space
    std::unique_ptr<const ShapeScene> scene_;
};

/// The masks of a graph of the recipe, at the points of the shape's mesh that are nearest to
/// `positions` in the SolidAtlas's space; their gradients are with respect to the texture's point.
MaskValues masks_at(const MeshShape& shape, const Recipe& recipe, const TextureGraph& graph,
                    std::span<const Vec3d> positions);

/// Gives images for the masks that a graph's output reads, at the texels of an atlas of the
/// pipeline's mesh. Once `stop` is requested they must not be used.
using MaskSource = std::function<MaskImages(const SolidAtlas&, const TextureGraph&,
                                            GraphOutput output, const std::stop_token& stop)>;

}  // namespace burl
