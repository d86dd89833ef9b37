#pragma once
// Patch atlases are better than quad atlases and take about ten times as long to lay out: an editor
// shows a large mesh with a quad atlas first and lays out the patches meanwhile.
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "app/editor/jobs/surface.h"
#include "app/editor/jobs/worker.h"
#include "app/pipeline/pipeline.h"

namespace burl {

/// The number of triangles above which patches are laid out in the background: patches of so many
/// triangles take about a second on two cores.
inline constexpr std::size_t many_faces = 40000;

/// Returns the atlas to show a mesh with at once: `wanted`, or, where patches of more than
/// `many_faces` triangles are wanted, a quad atlas of the largest power of two not above the wanted
/// size.
AtlasOptions atlas_at_once(const AtlasOptions& wanted, std::size_t triangles);

/// Returns a pipeline for a sequence of recipes, with a cache of 512 MB for intermediate values.
std::unique_ptr<Pipeline> make_edit_pipeline(Mesh mesh);

/// Lays out the atlas that a recipe asks for in the background, one at a time, while a quad atlas
/// is shown. All functions may be called by any thread.
class BackgroundAtlas {
  public:
    /// The atlas laid out and what is shown of it.
    struct Result {
        std::uint64_t mesh = 0;  ///< the caller's number of the mesh
        std::unique_ptr<Pipeline> pipeline{};
        std::shared_ptr<const MeshPose> pose{};  ///< pose of `surface`; null: none
        std::shared_ptr<EditSurface> surface{};
        std::shared_ptr<const SurfacePick> pick{};
    };

    /// `ended` is called by the thread of `jobs` when a result is there, or the layout has failed
    /// with the message `problem` (otherwise empty).
    BackgroundAtlas(JobQueue& jobs, std::function<void(const std::string& problem)> ended)
        : jobs_(jobs), ended_(std::move(ended)) {}

    /// Queues a job that lays out the recipe's atlas of a mesh and makes its texels' solid points,
    /// at low priority on all cores but one (on the only one, where there is one); nothing where
    /// one for the same atlas is under way.
    void begin(const Mesh& mesh, std::uint64_t number, std::shared_ptr<const MeshPose> pose,
               const Recipe& recipe);
    /// Whether a layout is under way.
    bool busy() const;
    /// Returns and clears the result; empty: none.
    std::optional<Result> take();
    /// Notes that the jobs queued were cancelled.
    void forget();

  private:
    void lay_out(Result result, const std::stop_token& stop);

    JobQueue& jobs_;
    std::function<void(const std::string& problem)> ended_;
    // `mutex_` guards begun_ and result_.
    mutable std::mutex mutex_;
    std::optional<AtlasOptions> begun_;  ///< atlas that was begun and not taken yet
    std::optional<Result> result_;
};

}  // namespace burl
