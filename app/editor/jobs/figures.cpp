#include "app/editor/jobs/figures.h"

#include <algorithm>
#include <cmath>

#include "atlas/base/weighted_percentile.h"

namespace burl {

namespace {

/// The areas of a triangle: on the surface in units of the scene, and in the texture of area 1.
struct Areas {
    double surface = 0.0, texture = 0.0;
};

std::vector<Areas> triangle_areas(const Scene& scene) {
    std::vector<Areas> areas;
    for (const Surface& surface : scene.surfaces) {
        if (surface.uvs.empty() || surface.placements.empty()) continue;
        const Mat3d place(surface.placements.front());
        for (const Triangle& t : surface.triangles) {
            const auto edge = [&](std::size_t k) {
                return place * (surface.positions[t[k]] - surface.positions[t[0]]);
            };
            const Vec2d u = surface.uvs[t[1]] - surface.uvs[t[0]];
            const Vec2d v = surface.uvs[t[2]] - surface.uvs[t[0]];
            areas.push_back({0.5 * glm::length(glm::cross(edge(1), edge(2))),
                             0.5 * std::abs(u.x * v.y - u.y * v.x)});
        }
    }
    return areas;
}

/// Returns the histogram's bin of a density, given as a multiple of the mean.
std::size_t bin_of(double density) {
    const double place = 0.5 + 0.5 * std::log(density) / std::log(AtlasFigures::reach);
    const double last = double(AtlasFigures::bins) - 1.0;
    return std::size_t(std::clamp(std::floor(place * (last + 1.0)), 0.0, last));
}

}  // namespace

AtlasFigures atlas_figures(const Scene& scene, std::uint32_t size) {
    AtlasFigures figures;
    figures.histogram.assign(AtlasFigures::bins, 0.0);
    double total = 0.0, ratios = 0.0;
    std::vector<WeightedValue> densities;
    for (const Areas& area : triangle_areas(scene)) {
        figures.coverage += area.texture;
        if (area.surface == 0.0) continue;
        total += area.surface;
        ratios += area.texture / area.surface;
        densities.push_back({area.texture / area.surface, area.surface});
    }
    if (densities.empty() || figures.coverage == 0.0) return figures;
    const double mean = figures.coverage / total;
    figures.relative_scale = std::sqrt(total * ratios / double(densities.size()));
    figures.texels_per_unit = double(size) * std::sqrt(mean);
    for (const WeightedValue& density : densities)
        figures.histogram[bin_of(density.value / mean)] += density.area / total;
    std::sort(densities.begin(), densities.end());
    constexpr std::array<double, 3> shares{0.05, 0.5, 0.95};
    for (std::size_t i = 0; i < shares.size(); ++i)
        figures.density[i] = weighted_percentile(densities, total, shares[i]) / mean;
    return figures;
}

std::shared_ptr<const AtlasFigures> EditFigures::of(
    const std::shared_ptr<const EditSurface>& surface) {
    const std::scoped_lock lock(mutex_);
    if (surface->number == surface_ && !busy_) return figures_;
    if (busy_) return nullptr;  // the caller asks again for the newest surface
    busy_ = true;
    surface_ = surface->number;
    figures_.reset();
    thread_ = std::jthread([this, surface] {
        auto figures =
            std::make_shared<const AtlasFigures>(atlas_figures(surface->scene, surface->size));
        {
            const std::scoped_lock done(mutex_);
            figures_ = std::move(figures);
            busy_ = false;
        }
        ready_.notify_all();
        wake_();
    });
    return nullptr;
}

void EditFigures::wait() const {
    std::unique_lock lock(mutex_);
    ready_.wait(lock, [&] { return !busy_; });
}

}  // namespace burl
