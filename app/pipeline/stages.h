#pragma once
// The stages between a mesh and its files: connectivity -> layout -> solid points -> masks ->
// texture -> levels, and normals. A stage is a value whose run() takes a context and its input and
// gives its result. A result that is asked for again is the cached one, for which an owner must
// forget() a stage before its input changes (Pipeline::set_recipe).
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <utility>
#include <variant>
#include <vector>

#include "app/pipeline/direct_levels.h"
#include "app/pipeline/fill_texture.h"
#include "app/pipeline/mesh_shape.h"
#include "app/pipeline/stage_records.h"
#include "app/pipeline/texture_cache.h"
#include "app/pipeline/texture_synthesizer.h"
#include "app/recipe/recipe.h"
#include "app/surface/tangents.h"
#include "atlas/build/mesh_atlas.h"
#include "atlas/solid/texel_set.h"
#include "procedural/fill/normals.h"
#include "procedural/fill/pictures.h"

namespace burl {

/// How stages run, on which no result depends but by the rounding of a kernel, and the records of
/// what they did.
struct StageContext {
    HostWay way{};          ///< how the host synthesises
    Skips skips{};          ///< which work may be left out
    std::size_t cache = 0;  ///< bytes for fields and octaves from one recipe to the next
    std::shared_ptr<TextureSynthesizer> synthesizer{};  ///< of level 0 of textures; null: the host
    /// A request that syntheses return soon, with results that must not be used.
    std::stop_token stop{};
    TaskMeter* meter = nullptr;  ///< is told what is done; null: nobody is
    StageRecords records{};

    /// Tells the meter what comes next, which may be so many texels.
    void begin(const char* task, std::uint64_t texels = 0) const {
        if (meter) meter->begin(task, texels, texels > 0);
    }
};

/// The mesh's edges: who is whose neighbour.
class ConnectivityStage {
  public:
    /// `labels` keep triangles apart (cut_between).
    const Connectivity& run(StageContext& context, const Mesh& mesh,
                            std::span<const std::uint32_t> labels = {});
    /// Frees the triangles' neighbours, 12 bytes per triangle, which layouts alone need.
    void release_neighbours();
    /// Whether the result has its counts alone.
    bool is_released() const { return edges_ && edges_->neighbours.empty(); }
    void forget() { edges_.reset(); }

  private:
    std::optional<Connectivity> edges_;
};

/// The atlas: where each triangle lies in the texture.
class LayoutStage {
  public:
    /// The mesh's atlas; null if `stop` was requested before it was made. Throws Error.
    const MeshAtlas* run(StageContext& context, const Mesh& mesh, const Connectivity& edges,
                         const AtlasOptions& options, const std::stop_token& stop = {});
    bool has_result() const { return atlas_.has_value(); }
    void forget() { atlas_.reset(); }

  private:
    std::optional<MeshAtlas> atlas_;
};

/// The solid points of the atlas's texels, as spans of rows.
class SolidStage {
  public:
    const SolidAtlas& run(StageContext& context, const Mesh& mesh, const MeshAtlas& atlas,
                          SolidSpace space);
    /// The solid points of level `level` of the atlas whose own are `finest` (atlas/solid/level.h).
    const SolidAtlas& run_level(const SolidAtlas& finest, std::uint32_t level);
    /// The solid points of the texels that show triangles of the label; `labels` are those of the
    /// mesh's triangles. They are valid until the next call.
    const SolidAtlas& run_share(const SolidAtlas& finest, const Mesh& mesh, const MeshAtlas& atlas,
                                std::span<const std::uint32_t> labels, std::uint32_t label);
    void forget();

  private:
    std::unique_ptr<const SolidAtlas> solid_;
    std::map<std::uint32_t, std::unique_ptr<const SolidAtlas>> levels_;
    std::vector<TexelSet> texels_of_labels_;
    std::optional<std::pair<std::uint32_t, SolidAtlas>> share_;  ///< with its label
};

/// The masks that textures and bumps read, as images over the atlas's texels.
class MaskStage {
  public:
    /// An image for each mask that the output of the recipe's `graph` reads at the texels of
    /// `solid`, a level of the recipe's atlas in its space. They have gradients where the recipe's
    /// texture or bumps take them. None is kept that was made when `stop` was requested; the result
    /// must then not be used.
    MaskImages run(StageContext& context, const Mesh& mesh, const MeshAtlas& atlas,
                   const SolidAtlas& solid, const Recipe& recipe, const TextureGraph& graph,
                   GraphOutput output, const std::stop_token& stop = {});
    /// Frees the images that neither the texture nor the bumps of the recipe read.
    void keep_those_of(const Recipe& recipe);
    void forget_images() { images_.clear(); }
    void forget();

  private:
    using Known = std::pair<TexelMaskKey, std::shared_ptr<const TexelField>>;
    std::shared_ptr<const TexelField> known(StageContext& context, const TexelMaskKey& key,
                                            bool slopes);

    std::unique_ptr<const MeshShape> shape_;
    std::vector<Known> images_;
};

/// The texture: field, colours and paint at solid points.
class TextureStage {
  public:
    /// The texture, or its level `level`, whose solid points are `solid`. Defined for Rgb8, Rgb16
    /// and RgbF (linear light).
    template <class Pixel>
    Image<Pixel> run(StageContext& context, const SolidAtlas& solid, const Recipe& recipe,
                     const MaskSource& masks, std::uint32_t level = 0);
    /// Gives the texture in linear light to `take` in bands whose rows are a multiple of band_rows
    /// (procedural/fill/synthesize.h), but for the last band. A band has about `texels` texels; the
    /// default makes 48 MB of float pixels. The time that `take` needs is not counted as synthesis.
    void run_in_bands(StageContext& context, const SolidAtlas& solid, const Recipe& recipe,
                      const MaskSource& masks, const TakeRows& take,
                      std::size_t texels = std::size_t(1) << 22) const;
    /// The pictures of the recipe's material by the host, without paint; none if `stop` was
    /// requested first. Defined for Rgba8, Rgba16 and RgbaF.
    template <class Pixel>
    std::vector<Image<Pixel>> run_pictures(StageContext& context, const SolidAtlas& solid,
                                           const Recipe& recipe, const MaskSource& masks,
                                           const std::vector<PicturePlan>& plans,
                                           const std::stop_token& stop) const;
    /// Gives the pictures of run_pictures() to `take` in bands of `rows` rows, whose time is not
    /// counted as synthesis. The result is not whole where the context is stopped.
    template <class Pixel>
    void run_pictures_in_bands(StageContext& context, const SolidAtlas& solid, const Recipe& recipe,
                               const MaskSource& masks, const std::vector<PicturePlan>& plans,
                               std::size_t rows, const TakePictures<Pixel>& take) const;
    /// The texture of a program that shows it while it changes; valid until the next call for that
    /// level. Null if `stop` was requested first. Defined for Rgb8, Rgb16 and RgbF.
    template <class Pixel>
    const Image<Pixel>* show(StageContext& context, const SolidAtlas& solid, const Recipe& recipe,
                             const MaskSource& masks, std::uint32_t level,
                             const std::stop_token& stop);
    /// Invalidates the pictures; cached fields and octaves stay.
    void forget_pictures();
    void forget() { levels_.clear(); }
    /// The size of cached fields and octaves in bytes.
    std::size_t cached_bytes() const;

  private:
    /// The caches of one level of the texture.
    struct Level {
        std::optional<TextureCache> texture{};
        std::optional<PaintCache> paint{};
    };
    Level& level(const StageContext& context, const SolidAtlas& solid, std::uint32_t number);

    std::map<std::uint32_t, Level> levels_;
};

/// The MIP levels 1 and up, averaged or synthesised by themselves (LevelRule).
class LevelStage {
  public:
    /// The levels 1 to `count` of `texture`, which is in linear light.
    std::vector<Image<RgbF>> run(StageContext& context, const MeshAtlas& atlas,
                                 const SolidAtlas& solid, const Recipe& recipe,
                                 const MaskSource& masks, const Image<RgbF>& texture,
                                 std::uint32_t count, const LevelRule& rule) const;
    /// The levels 1 to `count` of the texture whose bands run_in_bands gives to `take`.
    std::vector<Image<RgbF>> run_in_bands(StageContext& context, const MeshAtlas& atlas,
                                          const SolidAtlas& solid, const Recipe& recipe,
                                          const MaskSource& masks, const TextureStage& texture,
                                          std::uint32_t count, const LevelRule& rule,
                                          const TakeRows& take) const;
    /// The level `number` alone, by a direct rule.
    Image<RgbF> run_one(StageContext& context, const MeshAtlas& atlas, const SolidAtlas& solid,
                        const Recipe& recipe, const MaskSource& masks, std::uint32_t number,
                        const LevelRule& rule) const;
};

/// The normal map of the recipe's bumps.
class NormalStage {
  public:
    /// The map of Pipeline::normal_map. Defined for Rgb8 and Rgb16 (linear codes) and RgbF
    /// (components from -1 to 1).
    template <class Pixel>
    Image<Pixel> run(StageContext& context, const Mesh& mesh, const MeshAtlas& atlas,
                     const SolidAtlas& solid, const Recipe& recipe, const MaskSource& masks,
                     double crease_degrees, bool tangent_space);
    /// Gives the map in floats to `take` in bands of `rows` rows; none of it is kept.
    void run_in_bands(StageContext& context, const Mesh& mesh, const MeshAtlas& atlas,
                      const SolidAtlas& solid, const Recipe& recipe, const MaskSource& masks,
                      double crease_degrees, bool tangent_space, std::size_t rows,
                      const TakeNormals& take);
    void forget() { map_.reset(); }
    void forget_frames() { frames_.reset(); }

  private:
    /// The latest map with all that it depends on besides the atlas.
    struct Map {
        Bump bump;
        SolidOptions solid;
        Filter filter;
        PrecisionKind precision{};
        NormalFramesKey frames;
        std::vector<PaintStroke> mask_paint{};
        std::variant<Image<Rgb8>, Image<Rgb16>, Image<RgbF>> image{};
        bool is_of(const Recipe& recipe, const NormalFramesKey& key) const;
    };

    std::optional<NormalFrames> frames_;
    std::optional<Map> map_;
};

/// All stages, in the order in which data runs through them.
struct Stages {
    ConnectivityStage connectivity{};
    LayoutStage layout{};
    SolidStage solid{};
    MaskStage masks{};
    TextureStage texture{};
    LevelStage levels{};
    NormalStage normals{};
};

}  // namespace burl
