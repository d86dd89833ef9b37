#pragma once
// How the editor's atlas uses its texture (the measures of Carr & Hart 2001, section 3), from the
// scene that is drawn, once per surface on a thread of its own.
#include <array>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "app/editor/work/baker.h"

namespace burl {

struct AtlasFigures {
    double coverage = 0.0;            ///< share of the texture under triangles
    double relative_scale = 0.0;      ///< S of eq. (2), zero areas skipped
    std::array<double, 3> density{};  ///< area-weighted 5/50/95 %, the mean being 1
    double texels_per_unit = 0.0;     ///< along a line on the surface, by the mean density
    /// Share of the surface's area by its density: equal steps of its logarithm from 1/`reach` to
    /// `reach` times the mean, what lies beyond in the first and last one.
    std::vector<double> histogram{};
    static constexpr double reach = 4.0;
    static constexpr std::size_t bins = 40;
};

/// Of a scene whose texture is size x size texels; lengths are those of the scene. All zero for one
/// without area.
AtlasFigures atlas_figures(const Scene& scene, std::uint32_t size);

/// All functions may be called by one thread.
class EditFigures {
  public:
    /// `wake` is called by another thread when figures are ready.
    explicit EditFigures(std::function<void()> wake) : wake_(std::move(wake)) {}

    /// Of this surface, which is not null; null: being worked out.
    std::shared_ptr<const AtlasFigures> of(const std::shared_ptr<const EditSurface>& surface);
    void wait() const;

  private:
    std::function<void()> wake_;
    mutable std::mutex mutex_;  ///< of the next three
    mutable std::condition_variable ready_;
    std::shared_ptr<const AtlasFigures> figures_;
    bool busy_ = false;
    std::uint64_t surface_ = 0;  ///< whose they are
    std::jthread thread_;        ///< last: it sees all the others
};

}  // namespace burl
