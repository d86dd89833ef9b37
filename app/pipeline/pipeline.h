#pragma once
// A mesh, a recipe and the stages between them (app/pipeline/stages.h), for programs that ask for
// one result of several recipes one after the other: a new recipe repeats only the stages that
// depend on what it changes (table in docs/lab/economy.md).
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "app/pipeline/stages.h"

namespace burl {

/// Stages from a mesh to its textures, with cached results. Not to be used by two threads at a
/// time, but any thread may request a stop.
class Pipeline {
  public:
    /// Takes the mesh, which must have finite points and at least one triangle, as read_mesh
    /// guarantees.
    explicit Pipeline(Mesh mesh) : mesh_(std::move(mesh)) {}

    /// Sets the recipe; every cached result that the change leaves valid stays.
    void set_recipe(const Recipe& recipe);
    /// Sets the number of threads, 0 being all; no result depends on it.
    void set_threads(int threads) { context_.way.threads = threads; }
    /// Sets the kernel of the host's synthesis; cached pictures are invalidated if it changes.
    void set_kernel(Kernel kernel);
    /// Sets whether textures are synthesised by forward differences (HostWay::forward).
    void set_forward(bool forward);
    /// Sets which work may be left out; no result depends on it.
    void set_skips(const Skips& skips) { context_.skips = skips; }
    /// Sets the cache's budget for a sequence of recipes: textures, normal maps and at most `bytes`
    /// of fields and octaves stay from one recipe to the next. With 0, the default, only what
    /// picture() shows stays.
    void set_cache(std::size_t bytes);

    /// Sets who synthesises level 0 of textures; null: the host. Its problem() must be empty for
    /// every recipe that is synthesised.
    void set_synthesizer(std::shared_ptr<TextureSynthesizer> synthesizer);

    /// Sets the labels of the mesh's triangles, those of recipes that share the atlas, whose charts
    /// end where labels change; empty: all triangles are alike.
    void set_labels(std::vector<std::uint32_t> labels);
    /// Has textures, pictures and normal maps show the triangles of a label alone; none: all.
    /// Other texels are as those that show nothing.
    void show_label(std::optional<std::uint32_t> label);

    const Mesh& mesh() const { return mesh_; }
    /// The mesh whose triangles the atlas places, which is the one to export.
    const Mesh& atlas_mesh() { return mesh_atlas().mesh(mesh_); }
    const Recipe& recipe() const { return recipe_; }
    /// The mesh's connectivity; computed on the first call.
    const Connectivity& connectivity() {
        return stages_.connectivity.run(context_, mesh_, labels_);
    }
    /// Makes the recipe's atlas, which mesh_atlas() would do otherwise; false if `stop` was
    /// requested first. Throws Error.
    bool lay_out(const std::stop_token& stop);
    /// The recipe's atlas; made on the first call. Throws Error.
    const MeshAtlas& mesh_atlas();
    const Atlas& atlas() { return mesh_atlas().atlas(); }
    /// The solid points of the texels of the texture's level `level`, in the recipe's space
    /// (atlas/solid/level.h); in level 0, of the label's texels where show_label() says one.
    const SolidAtlas& solid(std::uint32_t level = 0);
    /// The source of masks of this pipeline's mesh over levels of its atlas; it refers to the
    /// pipeline, and images stay until the mask or the atlas changes.
    MaskSource masks();
    /// The texture, or level `level` of it, which the host synthesises without any finer level:
    /// point samples or filtered over the level's own texels, as the recipe says. Defined for Rgb8,
    /// Rgb16 and RgbF (linear light).
    template <class Pixel>
    Image<Pixel> synthesize(std::uint32_t level = 0) {
        return stages_.texture.run<Pixel>(context_, solid(level), recipe_, masks(), level);
    }
    /// The pictures of the recipe's material (app/pipeline/material.h) by the host, without paint,
    /// or level `level` of them; none if `stop` was requested first. Defined for Rgba8, Rgba16 and
    /// RgbaF.
    template <class Pixel>
    std::vector<Image<Pixel>> pictures(const std::vector<PicturePlan>& plans,
                                       std::uint32_t level = 0, const std::stop_token& stop = {}) {
        return stages_.texture.run_pictures<Pixel>(context_, solid(level), recipe_, masks(), plans,
                                                   stop);
    }
    /// Gives the pictures of the recipe's material, as pictures() makes them, to `take` in bands of
    /// `rows` rows; not all of them where the context is stopped.
    template <class Pixel>
    void pictures_in_bands(const std::vector<PicturePlan>& plans, std::size_t rows,
                           const TakePictures<Pixel>& take) {
        stages_.texture.run_pictures_in_bands<Pixel>(context_, solid(), recipe_, masks(), plans,
                                                     rows, take);
    }
    /// Whether the texture can be synthesised in bands of rows: by the host without a cache.
    bool has_bands() const { return context_.cache == 0 && !context_.synthesizer; }
    /// Gives the texture in linear light to `take` in bands whose rows are a multiple of band_rows
    /// (procedural/fill/synthesize.h), but for the last band. A band has about `texels` texels; the
    /// default makes 48 MB of float pixels. The time that `take` needs is not counted as synthesis.
    void synthesize_in_bands(const TakeRows& take, std::size_t texels = std::size_t(1) << 22) {
        stages_.texture.run_in_bands(context_, solid(), recipe_, masks(), take, texels);
    }
    /// The texture's level `level` for programs that show it while it changes; the image is valid
    /// until the next call for that level. Null if `stop` was requested first; cached octaves stay
    /// valid. Defined for Rgb8, Rgb16 and RgbF.
    template <class Pixel>
    const Image<Pixel>* picture(std::uint32_t level = 0, const std::stop_token& stop = {}) {
        return stages_.texture.show<Pixel>(context_, solid(level), recipe_, masks(), level, stop);
    }
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
    Image<Pixel> normal_map(double crease_degrees, bool tangent_space) {
        const SolidAtlas& points = solid();
        return stages_.normals.run<Pixel>(context_, mesh_, mesh_atlas(), points, recipe_, masks(),
                                          crease_degrees, tangent_space);
    }
    /// Gives the map of normal_map() in floats to `take` in bands of `rows` rows.
    void normals_in_bands(double crease_degrees, bool tangent_space, std::size_t rows,
                          const TakeNormals& take) {
        const SolidAtlas& points = solid();
        stages_.normals.run_in_bands(context_, mesh_, mesh_atlas(), points, recipe_, masks(),
                                     crease_degrees, tangent_space, rows, take);
    }

    /// Frees the solid points, some 170 bytes per triangle, masks, and the cached textures and
    /// normal maps; they are computed again when they are needed.
    void release_texels() { forget_solid(); }
    /// Frees the triangles' neighbours, 12 bytes per triangle, which layouts alone need;
    /// connectivity() has only its counts until another layout is made.
    void release_neighbours() {
        if (stages_.layout.has_result()) stages_.connectivity.release_neighbours();
    }

    /// The stages, for a caller that runs them one by one (app/bake/bake.cpp), and their context.
    Stages& stages() { return stages_; }
    StageContext& context() { return context_; }
    const StageRecords& records() const { return context_.records; }

  private:
    void forget_solid();

    Mesh mesh_;
    std::vector<std::uint32_t> labels_;   ///< one per triangle, or empty
    std::optional<std::uint32_t> label_;  ///< the label that is shown
    Recipe recipe_;
    StageContext context_;
    Stages stages_;
};

}  // namespace burl
