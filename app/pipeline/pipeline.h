#pragma once
// Mesh to pixels in one place, for the command line and for programs that edit a recipe: the
// stages' results are kept, and a new recipe repeats only what it changes (mesh -> connectivity ->
// layout -> spans -> field -> colours -> paint -> levels). docs/lab/economy.md has the table.
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
#include "app/surface/normal_frames.h"
#include "atlas/build/mesh_atlas.h"

namespace burl {

/// Not to be used by two threads at a time; a stop may be asked for by any.
class Pipeline {
  public:
    /// Takes the mesh; all its points must be finite and at least one triangle present, as
    /// read_mesh guarantees.
    explicit Pipeline(Mesh mesh);

    /// Keeps every result that the difference to the former recipe leaves valid.
    void set_recipe(const Recipe& recipe);
    /// 0 means as many as the machine has; no result depends on it.
    void set_threads(int threads) { way_.threads = threads; }
    /// Nor on this.
    void set_kernel(Kernel kernel);
    /// Whether textures come by forward differences (HostWay::forward).
    void set_forward(bool forward);
    /// What may be left out; no result depends on it.
    void set_skips(const Skips& skips) { skips_ = skips; }
    /// More than one texture will be asked for: textures, normal maps, and of the field and its
    /// octaves at most so many bytes are kept from one recipe to the next. 0, as at first: only
    /// what picture() shows is kept.
    void set_cache(std::size_t bytes);

    /// Makes the textures from now on instead of the host; null: the host. Its problem() must be
    /// empty for every recipe that is synthesised.
    void set_synthesizer(std::shared_ptr<TextureSynthesizer> synthesizer);

    const Mesh& mesh() const { return mesh_; }
    /// The mesh whose triangles the atlas places: what is exported.
    const Mesh& atlas_mesh() { return mesh_atlas().mesh(mesh_); }
    const Recipe& recipe() const { return recipe_; }
    const Connectivity& connectivity();
    /// Makes the recipe's atlas now rather than when it is asked for; false: `stop` came first.
    bool lay_out(const std::stop_token& stop);
    const MeshAtlas& mesh_atlas();
    const Atlas& atlas() { return mesh_atlas().atlas(); }
    /// The texels' solid points; those of a level of the texture (atlas/solid/level.h).
    const SolidAtlas& solid(std::uint32_t level = 0);
    /// The texture, or without working out anything finer a level of it, always by the host: point
    /// samples or filtered over the level's own texels, as the recipe says. One of Rgb8, Rgb16 and
    /// RgbF.
    template <class Pixel>
    Image<Pixel> synthesize(std::uint32_t level = 0);
    /// Whether the texture can come a band of rows at a time: from the host, where nothing is kept.
    bool has_bands() const { return cache_ == 0 && !synthesizer_; }
    /// The texture in linear light, a multiple of band_rows (procedural/fill/synthesize.h) at a
    /// time, but for the last ones. What `take` takes is not counted as synthesis. `texels` are
    /// about a band's: 48 MB of float pixels.
    void synthesize_in_bands(const TakeRows& take, std::size_t texels = std::size_t(1) << 22);
    /// The same for programs that show a texture while it changes. It stays until the next call for
    /// that level. Null: `stop` came first, and no field or octave kept before is lost.
    template <class Pixel>
    const Image<Pixel>* picture(std::uint32_t level = 0, const std::stop_token& stop = {});
    /// Levels 1 to `count` of a texture in linear light: averaged (atlas/build/block_levels.h), or
    /// direct, always by the host (app/pipeline/direct_levels.h).
    std::vector<Image<RgbF>> levels(const Image<RgbF>& texture, std::uint32_t count,
                                    const LevelRule& rule = {});
    /// The same where has_bands() and halves_in_bands (atlas/build/block_levels.h): `take` gets the
    /// texture, which is never there as a whole.
    std::vector<Image<RgbF>> levels_in_bands(std::uint32_t count, const LevelRule& rule,
                                             const TakeRows& take);
    /// Such a level alone: by a direct rule without working out anything finer than it samples.
    Image<RgbF> level(std::uint32_t number, const LevelRule& rule);
    /// The recipe's bumps, which it must have, as a normal map of the atlas's mesh with the normals
    /// of app/surface/normals.h, in the tangent frames of app/surface/tangents.h or in the mesh's
    /// own directions; one of Rgb8 and Rgb16, linear codes, and RgbF, components from -1 to 1.
    template <class Pixel>
    Image<Pixel> normal_map(double crease_degrees, bool tangent_space);

    /// Gives back what textures alone need, some 170 bytes a triangle; it is made again when it is
    /// asked for.
    void release_texels() { forget_solid(); }
    /// The same of what layouts alone need, 12 bytes a triangle: connectivity() is counts alone
    /// until another layout is made.
    void release_neighbours() {
        if (connectivity_) connectivity_->neighbours = {};
    }

    const StageRecords& records() const { return records_; }
    /// Bytes that the cache holds of fields and octaves.
    std::size_t cached_bytes() const;

  private:
    /// A texture's level: its points where they are not the atlas's own, and what is kept of it.
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
