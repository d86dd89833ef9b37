#pragma once
// The images that a bake writes: the texture with its MIP levels in the kind of its file, whole or
// in bands of rows, blocks of it that share a place, and the normal map.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/export/export.h"
#include "app/pipeline/pipeline.h"
#include "atlas/blocks/compress_blocks.h"

namespace burl {

/// The number of MIP levels above level 0, and their rule.
struct LevelsAsked {
    std::uint32_t count = 0;  ///< number of levels; 0: none
    LevelRule rule{};
};

/// Parses --levels and --level-rule. `text` is empty (no levels), a number, "all" (down to 1 x 1
/// for a texture of `size` texels a side) or the name of a rule (app/pipeline/direct_levels.h),
/// which means all levels by that rule. Too large numbers mean all; for float images any number but
/// 0 does, since their files hold all levels or none. `rule` names the rule otherwise; empty:
/// average. Throws Error(usage).
LevelsAsked levels_asked(const std::string& text, const std::string& rule, std::uint32_t size,
                         ImageKind kind);

/// The levels that a bake of the pipeline's recipe has: strip atlases have at most last_level. A
/// warning on stderr says that more are left out, or, in float images, mix unrelated triangles.
LevelsAsked levels_there_are(Pipeline& pipeline, const LevelsAsked& asked, ImageKind kind);

/// Space of a normal map's normals; none: no normal map.
enum class NormalSpace { none, tangent, object };

/// Parses --normals: none, tangent or object; empty means tangent if the recipe has bumps, else
/// none. Throws Error(usage) if normals are asked for and the recipe has no bumps, and for object
/// space in a glTF.
NormalSpace normals_asked(const std::string& text, const Recipe& recipe,
                          const std::string& out_path);

/// A texture and its MIP levels.
struct BakedTexture {
    BakedImage image{};
    std::vector<BakedImage> levels{};  ///< levels 1, 2, ...
};

/// The texture of the pipeline's recipe with levels_there_are, as images of `kind`.
BakedTexture bake_texture(Pipeline& pipeline, ImageKind kind, const LevelsAsked& levels);

/// The normal map of the pipeline's recipe, of 16 bits per channel if `depth` is 16, else 8; none
/// for NormalSpace::none. `recipes` are those that share the atlas; empty: the pipeline's.
std::optional<NormalMap> bake_normals(Pipeline& pipeline, NormalSpace space, int depth,
                                      double crease_degrees, std::span<const Recipe> recipes = {});

/// Adds MIP levels, unit vectors, in the codes of the map.
void add_levels(NormalMap& map, const std::vector<Image<RgbF>>& levels);

/// Writes level 0 of the map as a PNG file.
void encode_normals(const NormalMap& map, const PictureCoding& coding, const ByteSink& sink);

/// Turns the normals' second component round, for programs whose textures' second axis points up.
void turn_green(NormalMap& map);

/// The atlas and the texture that a bake writes, with the results of compression.
struct BakedAtlas {
    std::optional<Atlas> packed;  ///< the compressed atlas; none: the pipeline's atlas is written
    BakedImage image;
    std::optional<CompressNotes> compressed;  ///< results of compression; none: not compressed
};

/// The texture `image` of `atlas`, compressed (`burl bake --compress ERR`): blocks of the quad
/// atlas whose channels differ by no more than `most_error` (0 to 1, full scale) share a place.
/// Unchanged if `most_error` is none.
BakedAtlas compressed_bake(const Atlas& atlas, BakedImage image,
                           const std::optional<double>& most_error);

/// Whether the texture and `levels` can be made without the whole float texture in memory.
bool comes_in_bands(Pipeline& pipeline, const LevelsAsked& levels);

/// An .exr written in bands.
struct BandsWritten {
    std::size_t levels = 0;  ///< number of MIP levels in the file
    AtomicFile file;         ///< still to be committed
    double seconds = 0.0;    ///< time spent on the file, without the pipeline's stages
};

/// Writes the texture of the pipeline's recipe with its levels to `path`, an .exr, in bands of rows
/// while they are synthesised: a whole texture of 16384 x 16384 texels would take 3 GB.
/// comes_in_bands must hold. Throws Error(io).
BandsWritten write_exr_in_bands(Pipeline& pipeline, const std::string& path,
                                const LevelsAsked& levels, ExrDepth depth = ExrDepth::half);

}  // namespace burl
