#pragma once
// The masks that a graph reads (graph/masks.h) as images over the texels of an atlas.
#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "atlas/base/image.h"
#include "procedural/batch/texel_batch.h"
#include "procedural/graph/masks.h"
#include "procedural/graph/value_program.h"

namespace burl {

/// Images of a graph's masks, as large as the atlas's texture, by the masks' numbers; null for
/// those that nothing reads.
using MaskImages = std::vector<std::shared_ptr<const Image<float>>>;

/// Throws Error(unsupported), naming the node, where the graph's output reads a mask without an
/// image of `size` texels a side.
void check_masks(const TextureGraph& graph, GraphOutput output, const MaskImages& masks,
                 std::size_t size);

/// Writes the masks of pieces' texels, one piece after the other, into a value program's arrays.
inline void read_masks(const MaskImages& masks, std::span<const Piece> pieces,
                       std::span<ValueProgram::Scratch::Array> arrays) {
    for (std::size_t m = 0; m < std::min(masks.size(), arrays.size()); ++m) {
        if (!masks[m]) continue;
        double* to = arrays[m].values;
        for (const Piece& piece : pieces)
            to = std::copy_n(&(*masks[m])(piece.x, piece.y), piece.solid.count, to);
    }
}

/// Appends the masks of a texel `times` times.
inline void append_masks(const MaskImages& masks, std::size_t x, std::size_t y, std::size_t times,
                         MaskValues& values) {
    values.resize(masks.size());
    for (std::size_t m = 0; m < masks.size(); ++m)
        if (masks[m]) values[m].insert(values[m].end(), times, double((*masks[m])(x, y)));
}

/// Removes all values, but keeps their memory.
inline void clear_masks(MaskValues& values) {
    for (std::vector<double>& one : values) one.clear();
}

}  // namespace burl
