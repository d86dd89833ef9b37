#pragma once
// How well the editor's atlas uses its texture (the measures of Carr & Hart 2001, section 3),
// computed from the scene that is drawn, once per surface on a thread of its own.
#include <array>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "app/editor/jobs/surface.h"

namespace burl {

/// Measures of an atlas; densities are texels per area of the surface.
struct AtlasFigures {
    double coverage = 0.0;        ///< share of the texture's area covered by triangles
    double relative_scale = 0.0;  ///< relative scale S, eq. (2); triangles without area are skipped
    /// Area-weighted percentiles 5, 50 and 95 of the density divided by its mean.
    std::array<double, 3> density{};
    /// The root of the mean density: texels per unit of length of the scene.
    double texels_per_unit = 0.0;
    /// Shares of the surface's area by density, sum 1: `bins` equal steps of the logarithm from
    /// 1/`reach` to `reach` times the mean density; the end bins also count what lies beyond.
    std::vector<double> histogram{};
    static constexpr double reach = 4.0;
    static constexpr std::size_t bins = 40;
};

/// Measures the atlas of a scene whose texture has size x size texels. All values are zero for a
/// scene without area or without texture coordinates.
AtlasFigures atlas_figures(const Scene& scene, std::uint32_t size);

/// Measures surfaces in the background. All functions may be called by one thread.
class EditFigures {
  public:
    /// `wake` is called by the measuring thread when figures are ready.
    explicit EditFigures(std::function<void()> wake) : wake_(std::move(wake)) {}

    /// Returns the figures of `surface`, which must not be null, or null while they are computed;
    /// the caller asks again after `wake`.
    std::shared_ptr<const AtlasFigures> of(const std::shared_ptr<const EditSurface>& surface);
    /// Blocks until no surface is being measured.
    void wait() const;

  private:
    std::function<void()> wake_;
    // `mutex_` guards figures_, busy_ and surface_; `ready_` is notified when busy_ becomes false.
    mutable std::mutex mutex_;
    mutable std::condition_variable ready_;
    std::shared_ptr<const AtlasFigures> figures_;
    bool busy_ = false;
    std::uint64_t surface_ = 0;  ///< number of the surface that is or was measured
    std::jthread thread_;        ///< last member: its thread uses the others
};

}  // namespace burl
