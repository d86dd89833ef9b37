#pragma once
// Mesh to pixels in one place, for the command line now and the editor later: the stages' results
// are kept, and a new recipe drops only those that it changes (mesh -> connectivity -> layout ->
// spans -> pixels).
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/recipe.h"
#include "app/texture_synthesizer.h"
#include "atlas/mesh_atlas.h"
#include "procedural/kernel.h"

namespace burl {

/// Seconds a stage took, in the order the stages ran; a stage that was kept is not listed.
struct StageTime {
    std::string stage;
    double seconds = 0.0;
};

class Pipeline {
  public:
    /// Takes the mesh; all its points must be finite and at least one triangle present, as
    /// read_mesh guarantees.
    explicit Pipeline(Mesh mesh);

    /// Keeps every result that the difference to the former recipe leaves valid.
    void set_recipe(const Recipe& recipe);
    /// 0 means as many as the machine has; no result depends on it.
    void set_threads(int threads) { threads_ = threads; }
    /// Nor on this.
    void set_kernel(Kernel kernel) { kernel_ = kernel; }
    /// Whether textures come by forward differences, in the recipe's precision or else float64;
    /// check_forward (app/forward_check.h) must let the recipe pass then.
    void set_forward(bool forward) { forward_ = forward; }

    /// Makes the textures from now on instead of the host; null: the host. Its problem() must be
    /// empty for every recipe that is synthesised.
    void set_synthesizer(std::shared_ptr<TextureSynthesizer> synthesizer) {
        synthesizer_ = std::move(synthesizer);
    }

    const Mesh& mesh() const { return mesh_; }
    /// The mesh whose triangles the atlas places: what is exported.
    const Mesh& atlas_mesh() { return mesh_atlas().mesh(mesh_); }
    const Recipe& recipe() const { return recipe_; }
    const Connectivity& connectivity();
    const MeshAtlas& mesh_atlas();
    const Atlas& atlas() { return mesh_atlas().atlas(); }
    const SolidAtlas& solid();
    /// The texture; one of Rgb8, Rgb16 and RgbF.
    template <class Pixel>
    Image<Pixel> synthesize();
    /// Levels 1 to `count` of a texture in linear light (atlas/block_levels.h).
    std::vector<Image<RgbF>> levels(const Image<RgbF>& texture, std::uint32_t count);
    /// The recipe's bumps, which it must have, as a normal map of the atlas's mesh with the normals
    /// of app/normals.h, in the tangent frames of app/tangents.h or in the mesh's own directions;
    /// one of Rgb8 and Rgb16, linear codes, and RgbF, components from -1 to 1.
    template <class Pixel>
    Image<Pixel> normal_map(double crease_degrees, bool tangent_space);

    const std::vector<StageTime>& times() const { return times_; }

  private:
    template <class Stage>
    auto timed(const char* name, Stage&& stage);

    Mesh mesh_;
    Recipe recipe_;
    int threads_ = 0;
    Kernel kernel_ = Kernel::automatic;
    bool forward_ = false;
    std::shared_ptr<TextureSynthesizer> synthesizer_;
    std::optional<Connectivity> connectivity_;
    std::optional<MeshAtlas> atlas_;
    std::optional<SolidAtlas> solid_;
    std::vector<StageTime> times_;
};

}  // namespace burl
