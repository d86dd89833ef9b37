#pragma once
// The masks that a graph reads (graph/masks.h) as images over the texels of an atlas.
#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "atlas/solid/texel_field.h"
#include "procedural/batch/texel_batch.h"
#include "procedural/graph/masks.h"
#include "procedural/graph/value_program.h"

namespace burl {

/// Images of a graph's masks, as large as the atlas's texture, by the masks' numbers; null for
/// those that nothing reads. Their gradients are needed where a texel's samples or its footprint,
/// bumps or the node `slope` read them; without them these take a mask for constant.
using MaskImages = std::vector<std::shared_ptr<const TexelField>>;

/// Throws Error(unsupported), naming the node, where the graph's output reads a mask without an
/// image of `size` texels a side.
void check_masks(const TextureGraph& graph, GraphOutput output, const MaskImages& masks,
                 std::size_t size);

/// The matrix that takes gradients with respect to points to those with respect to map(points); 0
/// for a map that is flat.
Mat3d gradients_after(const Affine3& map);

/// The masks of texels, with gradients with respect to the texture's point.
class MaskReader {
  public:
    /// `texture_from_atlas` maps the SolidAtlas's space to the texture's. `masks` must outlive the
    /// object.
    MaskReader(const MaskImages& masks, const Affine3& texture_from_atlas);

    std::size_t size() const { return masks_.size(); }
    bool has(std::size_t mask) const { return masks_[mask] != nullptr; }
    /// Mask number `mask`, which there must be, at a texel.
    Dual operator()(std::size_t mask, std::size_t x, std::size_t y) const {
        const TexelField& field = *masks_[mask];
        return {double(field.values(x, y)), to_texture_ * field.slope(x, y)};
    }

    /// Appends a texel's masks at the point that lies `off` its own, along the surface.
    void append(std::size_t x, std::size_t y, const Vec3d& off, MaskValues& values) const;
    /// Writes the masks of pieces' texels, one piece after the other, into a value program's
    /// arrays.
    void read(std::span<const Piece> pieces, ValueProgram::Scratch& scratch) const;

  private:
    const MaskImages& masks_;
    Mat3d to_texture_;  ///< takes gradients from the SolidAtlas's space to the texture's
};

/// A mask at the point that lies `off` that of its value, along the surface.
inline Dual moved(const Dual& mask, const Vec3d& off) {
    return {mask.value + glm::dot(mask.slope, off), mask.slope};
}

/// Removes all values, but keeps their memory.
inline void clear_masks(MaskValues& values) {
    for (std::vector<Dual>& one : values) one.clear();
}

}  // namespace burl
