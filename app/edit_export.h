#pragma once
// Exports beside the user interface: what `burl bake` writes for the recipe, by a pipeline of its
// own, so that sliders can go on moving meanwhile.
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "app/recipe.h"

namespace burl {

class EditExport {
  public:
    /// `wake` is called by another thread when an export has ended.
    explicit EditExport(std::function<void()> wake) : wake_(std::move(wake)) {}

    /// Begins once the last one has ended. The mesh is read anew.
    void start(std::string mesh_path, Recipe recipe, std::string out_path);
    bool busy() const;
    void wait();
    /// How the last one ended, once: the sentence, and whether it is a problem.
    struct Outcome {
        bool problem = false;
        std::string text{};
    };
    std::optional<Outcome> take_outcome();

  private:
    void run(const std::string& mesh_path, const Recipe& recipe, const std::string& out_path);

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    bool busy_ = false;
    std::optional<Outcome> outcome_;
    std::jthread thread_;
};

/// Reads a mesh file or sample, textures it and writes everything or nothing, as `burl bake` does
/// without options. Throws Error.
void bake_file(const std::string& mesh_path, const Recipe& recipe, const std::string& out_path);

/// A mesh file, or "sample:NAME".
Mesh load_mesh(const std::string& path);

}  // namespace burl
