#pragma once
// Exports beside the user interface: what `burl bake` writes for the recipe, by a pipeline of its
// own, so that sliders can go on moving meanwhile.
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/recipe/recipe.h"

namespace burl {

struct ExportRequest {
    std::string mesh{};   ///< a mesh file or sample
    Recipe recipe{};      ///< one with keys over time becomes the textures of all its frames
    std::string out{};    ///< its extension says what is written
    bool levels = false;  ///< all MIP levels besides the texture
    std::string pose{};   ///< of the mesh (app/surface/load_pose.h); empty: none
    /// A file or preset, whose folder the images' names lead from; empty: none.
    std::string recipe_path{};
};

/// Whether it is the texture as a shader: .frag or .glsl.
bool is_shader_file(const std::string& path);

/// The options of `burl bake` that write the same: -o and what else is needed.
std::vector<std::string> bake_options(const ExportRequest& request);

/// All files that bake_file, or of a recipe with keys bake_frames, would write; the one named alone
/// where it cannot be written.
std::vector<std::string> export_files(const ExportRequest& request);

/// Reads the mesh, textures it and writes everything or nothing, as `burl bake` does with
/// bake_options(). Throws Error; before any work where a file that is read would be replaced.
void bake_file(const ExportRequest& request);

/// The textures of the frames of a recipe with keys (app/recipe/keyed_recipe.h), at its own rate:
/// the files of `burl bake --frames`. Throws Error; before any work where `out` is no texture or a
/// file that is read would be replaced.
void bake_frames(const ExportRequest& request);

class EditExport {
  public:
    /// `wake` is called by another thread when an export has ended.
    explicit EditExport(std::function<void()> wake) : wake_(std::move(wake)) {}

    /// Begins once the last one has ended.
    void start(ExportRequest request);
    bool busy() const;
    void wait();
    /// How the last one ended, once: the sentence, and whether it is a problem.
    struct Outcome {
        bool problem = false;
        std::string text{};
    };
    std::optional<Outcome> take_outcome();

  private:
    void run(const ExportRequest& request);

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    bool busy_ = false;
    std::optional<Outcome> outcome_;
    std::jthread thread_;
};

}  // namespace burl
