#pragma once
// `burl bake --compress ERR`: alike blocks of the quad atlas share a place in the written texture.
#include <optional>

#include "app/export/export.h"
#include "app/measure/report.h"
#include "atlas/blocks/compress_blocks.h"

namespace burl {

/// What is written of a bake: the atlas with its picture, and what compressing found.
struct BakedAtlas {
    std::optional<Atlas> packed;  ///< nothing: the pipeline's own
    BakedImage image;
    std::optional<CompressNotes> compressed;  ///< of `packed`
};

/// Throws Error(usage) before any work: `most_error` is asked for and the kind is not quad.
void check_compress(const std::optional<double>& most_error, AtlasKind kind);

/// As it is without `most_error`.
BakedAtlas compressed_bake(const Atlas& atlas, BakedImage image,
                           const std::optional<double>& most_error);

/// Blocks, texels and uncompressed bytes before and after, and the largest error made.
Json compress_json(const BakedAtlas& baked);
/// Prints what compress_json says.
void print_compressed(const Json& compressed);

}  // namespace burl
