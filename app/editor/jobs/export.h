#pragma once
// Exports in the background: the files that `burl bake` would write for the recipe, made by a
// pipeline of their own while the editor's goes on.
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "app/base/course.h"
#include "app/recipe/recipe.h"

namespace burl {

/// An export: its inputs and its output file.
struct ExportRequest {
    std::string mesh{};  ///< mesh file, or "sample:NAME"
    /// A recipe with animation tracks is exported as the textures of all its frames.
    Recipe recipe{};
    std::string out{};    ///< output file; its extension is its format
    bool levels = false;  ///< whether all MIP levels are written besides the texture
    std::string pose{};   ///< pose of the mesh (app/surface/sample_meshes.h); empty: none
    /// The recipe's file or preset; image names are relative to its folder. Empty: none.
    std::string recipe_path{};
    std::vector<std::string> masks{};  ///< masks written besides (app/pipeline/mask_picture.h)
};

/// Whether `path` names a fragment shader: the extension is .frag or .glsl.
bool is_shader_file(const std::string& path);

/// The options of `burl bake` that write the same files: -o and those that its default lacks.
std::vector<std::string> bake_options(const ExportRequest& request);

/// All files that bake_file() (bake_frames() for a recipe with animation tracks) would write; `out`
/// alone where the request cannot be exported.
std::vector<std::string> export_files(const ExportRequest& request);

/// Reads the mesh, bakes the texture and writes all files or none, as `burl bake` does with
/// bake_options(). Throws Error, and does so before baking where an input would be overwritten.
/// Throws Error(runtime) where `stop` is requested; then nothing was written. `told` is told how
/// far it is; null: nobody is.
void bake_file(const ExportRequest& request, const std::stop_token& stop = {},
               Course* told = nullptr);

/// Bakes and writes the textures of all frames of a recipe with animation tracks
/// (app/recipe/edit/keyed_recipe.h) at the recipe's own frame rate: the files of `burl bake
/// --frames`. Throws Error, and does so before baking where `out` is no texture or an input would
/// be overwritten.
/// Throws Error(runtime) where `stop` is requested; frames that were done stay.
void bake_frames(const ExportRequest& request, const std::stop_token& stop = {},
                 Course* told = nullptr);

/// Runs one export at a time on a thread of its own. All functions may be called by one thread.
class EditExport {
  public:
    /// `wake` is called by a thread ten times a second during an export, and when it has ended.
    explicit EditExport(std::function<void()> wake) : wake_(std::move(wake)) {}

    /// Waits for the running export, then starts this one.
    void start(ExportRequest request);
    /// Whether an export is running.
    bool busy() const;
    /// How far the running export has come.
    ProgressState progress() const;
    /// Requests that the running export stops; its outcome says so.
    void stop() { thread_.request_stop(); }
    /// Blocks until no export is running.
    void wait();
    /// The result of an export: one sentence, and whether it reports a failure.
    struct Outcome {
        bool problem = false;
        std::string text{};
    };
    /// Returns and clears the result of the last export; empty: none ended since.
    std::optional<Outcome> take_outcome();

  private:
    void run(const ExportRequest& request, const std::stop_token& stop);
    void wake_until(const std::stop_token& done);

    std::function<void()> wake_;
    // `mutex_` guards busy_, course_ and outcome_.
    mutable std::mutex mutex_;
    bool busy_ = false;
    std::shared_ptr<Course> course_;  ///< of the last export
    std::optional<Outcome> outcome_;
    std::jthread thread_;
};

}  // namespace burl
