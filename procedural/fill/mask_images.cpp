#include "procedural/fill/mask_images.h"

#include <fmt/format.h>

#include "atlas/base/error.h"

namespace burl {

void check_masks(const TextureGraph& graph, GraphOutput output, const MaskImages& masks,
                 std::size_t size) {
    const std::vector<bool> read = masks_read(graph, output);
    for (std::size_t m = 0; m < read.size(); ++m) {
        const bool there = m < masks.size() && masks[m] && masks[m]->values.width() == size;
        if (read[m] && !there)
            throw Error(ExitCode::unsupported,
                        fmt::format("the texture cannot be filled: {}; bake it",
                                    no_texels_for(first_mask_node(graph, output))));
    }
}

Mat3d gradients_after(const Affine3& map) {
    if (glm::determinant(map.linear) == 0.0) return Mat3d(0.0);
    return glm::transpose(glm::inverse(map.linear));
}

MaskReader::MaskReader(const MaskImages& masks, const Affine3& texture_from_atlas)
    : masks_(masks), to_texture_(gradients_after(texture_from_atlas)) {}

void MaskReader::append(std::size_t x, std::size_t y, const Vec3d& off, MaskValues& values) const {
    values.resize(size());
    for (std::size_t m = 0; m < size(); ++m)
        if (has(m)) values[m].push_back(moved((*this)(m, x, y), off));
}

void MaskReader::read(std::span<const Piece> pieces, ValueProgram::Scratch& scratch) const {
    for (std::size_t m = 0; m < std::min(size(), scratch.masks.size()); ++m) {
        if (!has(m)) continue;
        std::size_t j = 0;
        for (const Piece& piece : pieces)
            for (std::size_t x = piece.x; x < piece.x + piece.solid.count; ++x, ++j) {
                scratch.masks[m].values[j] = double(masks_[m]->values(x, piece.y));
                if (scratch.mask_slopes.empty()) continue;
                const Vec3d slope = to_texture_ * masks_[m]->slope(x, piece.y);
                for (std::size_t axis = 0; axis < 3; ++axis)
                    scratch.mask_slopes[m][axis].values[j] = slope[int(axis)];
            }
    }
}

}  // namespace burl
