#pragma once
// The pipeline from mesh to pixels, for the command line and for programs that edit a recipe: mesh
// -> connectivity -> layout -> spans -> field -> colours -> paint -> levels. The stages' results
// are cached, and a new recipe repeats only the stages that depend on what it changes (table in
// docs/lab/economy.md).
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

#include "app/pipeline/direct_levels.h"
#include "app/pipeline/fill_texture.h"
#include "app/pipeline/kept_paint.h"
#include "app/pipeline/kept_texture.h"
#include "app/pipeline/stage_records.h"
#include "app/pipeline/texture_synthesizer.h"
#include "app/recipe/recipe.h"
#include "app/surface/tangents.h"
#include "atlas/build/mesh_atlas.h"

namespace burl {

/// Stages from a mesh to its textures, with cached results. Not to be used by two threads at a
/// time, but any thread may request a stop.
class Pipeline {
  public:
    /// Takes the mesh, which must have finite points and at least one triangle, as read_mesh
    /// guarantees.
    explicit Pipeline(Mesh mesh);

    /// Sets the recipe; every cached result that the change leaves valid stays.
    void set_recipe(const Recipe& recipe);
    /// Sets the number of threads, 0 being all; no result depends on it.
    void set_threads(int threads) { way_.threads = threads; }
    /// Sets the kernel of the host's synthesis; cached pictures are invalidated if it changes.
    void set_kernel(Kernel kernel);
    /// Sets whether textures are synthesised by forward differences (HostWay::forward).
    void set_forward(bool forward);
    /// Sets which work may be left out; no result depends on it.
    void set_skips(const Skips& skips) { skips_ = skips; }
    /// Sets the cache's budget for a sequence of recipes: textures, normal maps and at most `bytes`
    /// of fields and octaves stay from one recipe to the next. With 0, the default, only what
    /// picture() shows stays.
    void set_cache(std::size_t bytes);

    /// Sets who synthesises level 0 of textures; null: the host. Its problem() must be empty for
    /// every recipe that is synthesised.
    void set_synthesizer(std::shared_ptr<TextureSynthesizer> synthesizer);

    const Mesh& mesh() const { return mesh_; }
    /// The mesh whose triangles the atlas places, which is the one to export.
    const Mesh& atlas_mesh() { return mesh_atlas().mesh(mesh_); }
    const Recipe& recipe() const { return recipe_; }
    /// The mesh's connectivity; computed on the first call.
    const Connectivity& connectivity();
    /// Makes the recipe's atlas, which mesh_atlas() would do otherwise; false if `stop` was
    /// requested first. Throws Error.
    bool lay_out(const std::stop_token& stop);
    /// The recipe's atlas; made on the first call. Throws Error.
    const MeshAtlas& mesh_atlas();
    const Atlas& atlas() { return mesh_atlas().atlas(); }
    /// The solid points of the texels of the texture's level `level`, in the recipe's space
    /// (atlas/solid/level.h).
    const SolidAtlas& solid(std::uint32_t level = 0);
    /// The texture, or level `level` of it, which the host synthesises without any finer level:
    /// point samples or filtered over the level's own texels, as the recipe says. Defined for Rgb8,
    /// Rgb16 and RgbF (linear light).
    template <class Pixel>
    Image<Pixel> synthesize(std::uint32_t level = 0);
    /// Whether the texture can be synthesised in bands of rows: by the host without a cache.
    bool has_bands() const { return cache_ == 0 && !synthesizer_; }
    /// Gives the texture in linear light to `take` in bands whose rows are a multiple of band_rows
    /// (procedural/fill/synthesize.h), but for the last band. A band has about `texels` texels; the
    /// default makes 48 MB of float pixels. The time that `take` needs is not counted as synthesis.
    void synthesize_in_bands(const TakeRows& take, std::size_t texels = std::size_t(1) << 22);
    /// The texture's level `level` for programs that show it while it changes; the image is valid
    /// until the next call for that level. Null if `stop` was requested first; cached octaves stay
    /// valid. Defined for Rgb8, Rgb16 and RgbF.
    template <class Pixel>
    const Image<Pixel>* picture(std::uint32_t level = 0, const std::stop_token& stop = {});
    /// The levels 1 to `count` of `texture`, which is in linear light: averaged
    /// (atlas/build/block_levels.h), or direct and synthesised by the host
    /// (app/pipeline/direct_levels.h).
    std::vector<Image<RgbF>> levels(const Image<RgbF>& texture, std::uint32_t count,
                                    const LevelRule& rule = {});
    /// The levels 1 to `count` of the recipe's texture, whose bands `take` gets: the whole texture
    /// is never in memory. has_bands() and halves_in_bands (atlas/build/block_levels.h) must hold.
    std::vector<Image<RgbF>> levels_in_bands(std::uint32_t count, const LevelRule& rule,
                                             const TakeRows& take);
    /// Level `number` alone, in linear light; a direct rule synthesises nothing finer than the
    /// level's samples.
    Image<RgbF> level(std::uint32_t number, const LevelRule& rule);
    /// The normal map of the recipe's bumps, of which it must have some, on the atlas's mesh with
    /// the normals of app/surface/normals.h: in the tangent frames of app/surface/tangents.h, or in
    /// the mesh's space. Defined for Rgb8 and Rgb16 (linear codes) and RgbF (components from -1 to
    /// 1).
    template <class Pixel>
    Image<Pixel> normal_map(double crease_degrees, bool tangent_space);

    /// Frees the solid points, some 170 bytes per triangle, and the cached textures and normal
    /// maps; they are computed again when they are needed.
    void release_texels() { forget_solid(); }
    /// Frees the triangles' neighbours, 12 bytes per triangle, which layouts alone need;
    /// connectivity() has only its counts until another layout is made.
    void release_neighbours() {
        if (connectivity_) connectivity_->neighbours = {};
    }

    const StageRecords& records() const { return records_; }
    /// The size of cached fields and octaves in bytes.
    std::size_t cached_bytes() const;

  private:
    /// Cache of a texture's level: its solid points (null for level 0, which has the atlas's),
    /// texture and paint.
    struct Level {
        std::unique_ptr<const SolidAtlas> solid{};
        std::unique_ptr<KeptTexture> kept{};
        std::unique_ptr<KeptPaint> paint{};
    };
    struct KeptNormals;

    void forget_solid();
    void forget_pictures();
    KeptTexture& kept(std::uint32_t number);
    const SolidAtlas& finest_solid();
    LevelSynthesis level_synthesis(StageCost& cost) const;
    template <class Pixel>
    const Image<Pixel>* unpainted(KeptTexture& texture, std::uint32_t level,
                                  const std::stop_token& stop);
    template <class Pixel>
    void paint(const SolidAtlas& points, Image<Pixel>& image);
    void synthesize_elsewhere(const SolidAtlas& points, ImageToFill image, StageCost& cost);
    const NormalFrames& frames(const NormalFramesKey& key);

    Mesh mesh_;
    Recipe recipe_;
    HostWay way_;
    Skips skips_;
    std::size_t cache_ = 0;
    std::shared_ptr<TextureSynthesizer> synthesizer_;
    std::optional<Connectivity> connectivity_;
    std::optional<MeshAtlas> atlas_;
    std::unique_ptr<const SolidAtlas> solid_;
    std::map<std::uint32_t, Level> levels_;
    std::optional<NormalFrames> frames_;
    std::shared_ptr<KeptNormals> normals_;
    StageRecords records_;
};

}  // namespace burl
