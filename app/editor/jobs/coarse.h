#pragma once
// What the editor draws of a large surface while it moves: a surface of few triangles, made beside
// the user interface and thrown away with the large one.
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "app/editor/jobs/surface.h"

namespace burl {

/// A coarse surface (app/scene/coarse_surface.h) for every one of a scene.
using CoarseSurfaces = std::vector<Surface>;

/// Returns coarse surfaces of at most about `most` triangles together, each with its share.
CoarseSurfaces coarse_surfaces(const Scene& scene, std::size_t most);

/// The triangles that a scene draws, in all its placements.
std::size_t drawn_triangles(const Scene& scene);

/// Makes coarse surfaces on a thread of its own. All functions may be called by one thread.
class EditCoarse {
  public:
    /// Scenes that draw more triangles than this have coarse surfaces; and how many these draw.
    static constexpr std::size_t many = 100'000, few = 25'000;

    /// `wake` is called by the worker's thread when coarse surfaces are ready.
    explicit EditCoarse(std::function<void()> wake) : wake_(std::move(wake)) {}

    /// Sets the surface to make coarse, once a frame; null: none.
    void follow(const std::shared_ptr<const EditSurface>& surface);
    /// The coarse surfaces of this surface; null: not ready, or it is not large.
    std::shared_ptr<const CoarseSurfaces> surfaces(
        const std::shared_ptr<const EditSurface>& of) const;

    bool idle() const { return jobs_.idle(); }
    void wait() const { jobs_.wait(); }

  private:
    void make(const std::shared_ptr<const EditSurface>& surface, const std::stop_token& stop);

    std::function<void()> wake_;
    // `mutex_` guards of_ and surfaces_.
    mutable std::mutex mutex_;
    std::uint64_t of_ = 0;  ///< number of the surface last set; 0: none
    std::shared_ptr<const CoarseSurfaces> surfaces_;
    JobQueue jobs_;  ///< last member: its thread uses all the others
};

}  // namespace burl
