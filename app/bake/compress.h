#pragma once
// `burl bake --compress ERR`: blocks of the quad atlas with similar texels share a place in the
// written texture.
#include <optional>

#include "app/export/export.h"
#include "app/measure/report.h"
#include "atlas/blocks/compress_blocks.h"

namespace burl {

/// The atlas and the texture that a bake writes, with the results of compression.
struct BakedAtlas {
    std::optional<Atlas> packed;  ///< the compressed atlas; none: the pipeline's atlas is written
    BakedImage image;
    std::optional<CompressNotes> compressed;  ///< results of compression; none: not compressed
};

/// Throws Error(usage) if compression is asked for (`most_error`) and the atlas is not a quad
/// atlas.
void check_compress(const std::optional<double>& most_error, AtlasKind kind);

/// The texture `image` of `atlas`, compressed so that no channel errs by more than `most_error` (0
/// to 1, full scale); unchanged if `most_error` is none.
BakedAtlas compressed_bake(const Atlas& atlas, BakedImage image,
                           const std::optional<double>& most_error);

/// The results of compression as JSON: blocks and places, texels and bytes before and after, and
/// the largest error. `baked` must be compressed.
Json compress_json(const BakedAtlas& baked);
/// Prints the JSON of compress_json as one line on stdout.
void print_compressed(const Json& compressed);

}  // namespace burl
