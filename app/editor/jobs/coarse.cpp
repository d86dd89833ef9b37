#include "app/editor/jobs/coarse.h"

#include <algorithm>
#include <utility>

#include "app/scene/coarse_surface.h"

namespace burl {

std::size_t drawn_triangles(const Scene& scene) {
    std::size_t all = 0;
    for (const Surface& surface : scene.surfaces)
        all += surface.triangles.size() * surface.placements.size();
    return all;
}

CoarseSurfaces coarse_surfaces(const Scene& scene, std::size_t most) {
    const double share = double(most) / double(std::max<std::size_t>(drawn_triangles(scene), 1));
    CoarseSurfaces coarse;
    for (const Surface& surface : scene.surfaces)
        coarse.push_back(
            coarse_surface(surface, std::size_t(share * double(surface.triangles.size()))));
    return coarse;
}

void EditCoarse::follow(const std::shared_ptr<const EditSurface>& surface) {
    const std::uint64_t number = surface ? surface->number : 0;
    {
        const std::scoped_lock lock(mutex_);
        if (std::exchange(of_, number) == number) return;
        surfaces_.reset();
    }
    jobs_.cancel();
    if (!surface || drawn_triangles(surface->scene) <= many) return;
    jobs_.add([this, surface](const std::stop_token& stop) { make(surface, stop); });
}

std::shared_ptr<const CoarseSurfaces> EditCoarse::surfaces(
    const std::shared_ptr<const EditSurface>& of) const {
    const std::scoped_lock lock(mutex_);
    return of && of->number == of_ ? surfaces_ : nullptr;
}

void EditCoarse::make(const std::shared_ptr<const EditSurface>& surface,
                      const std::stop_token& stop) {
    auto made = std::make_shared<const CoarseSurfaces>(coarse_surfaces(surface->scene, few));
    {
        const std::scoped_lock lock(mutex_);
        if (stop.stop_requested() || of_ != surface->number) return;
        surfaces_ = std::move(made);
    }
    wake_();
}

}  // namespace burl
