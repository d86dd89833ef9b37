#include "atlas/shape/texel_mask.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "atlas/base/each_index.h"

namespace burl {

namespace {

/// The gradient in float32, 0 where it is not finite.
Vec3f stored(const Vec3d& slope) {
    const Vec3f rounded(slope);
    const bool finite =
        std::isfinite(rounded.x) && std::isfinite(rounded.y) && std::isfinite(rounded.z);
    return finite ? rounded : Vec3f(0.0f);
}

/// Fills rows one by one, from the lattice where that is smooth, else by the mask itself.
class RowMask {
  public:
    RowMask(const SolidAtlas& solid, const TexelOwners& owners, const ShapeScene& shape,
            const ShapeMask& mask, const TexelMaskOptions& options)
        : solid_(solid), owners_(owners), shape_(shape), mask_(mask), options_(options) {
        const bool differences = options.slopes && !mask.slopes;
        if (options.spacing > 0.0 || differences)
            lattice_.emplace(solid, owners, shape, mask.values,
                             LatticeOptions{options.spacing > 0.0 ? options.spacing : 1.0,
                                            differences, options.stop});
    }

    void fill(std::size_t y, TexelField& field) const {
        if (options_.stop.stop_requested()) return;
        Points asked, sloped;
        for (const Span& span : solid_.row(y))
            for (std::uint32_t x = span.x; x < span.x + span.count; ++x)
                add(x, std::uint32_t(y), span.map, field, asked, sloped);
        std::vector<float> values(asked.points.size());
        mask_.values(asked.points, values);
        for (std::size_t i = 0; i < values.size(); ++i)
            field.values(asked.places[i], y) = values[i];
        if (sloped.points.empty()) return;
        std::vector<Vec3d> slopes(sloped.points.size());
        mask_.slopes(sloped.points, slopes);
        for (std::size_t i = 0; i < slopes.size(); ++i)
            field.slopes(sloped.places[i], y) = stored(slopes[i]);
    }

  private:
    /// Texels of a row, and the points that they show.
    struct Points {
        std::vector<std::uint32_t> places;
        std::vector<ShapePoint> points;
        void add(std::uint32_t x, const ShapePoint& point) {
            places.push_back(x);
            points.push_back(point);
        }
    };

    /// Fills a texel from the lattice, and adds its point to those that are asked for more.
    void add(std::uint32_t x, std::uint32_t y, std::uint32_t map, TexelField& field, Points& asked,
             Points& sloped) const {
        const auto [triangle, weights] = place_shown(solid_, owners_, shape_, x, y, map);
        if (const auto value = interpolated(triangle, weights))
            field.values(x, y) = *value;
        else
            asked.add(x, shape_.surface_point(triangle, weights));
        if (!options_.slopes) return;
        if (mask_.slopes)
            sloped.add(x, shape_.surface_point(triangle, weights));
        else
            field.slopes(x, y) = stored(lattice_->slope(triangle, weights));
    }

    std::optional<float> interpolated(std::uint32_t triangle, const Vec3d& weights) const {
        if (!(options_.spacing > 0.0) || !lattice_->covers(triangle)) return {};
        const LatticeCell cell = lattice_->at(triangle, weights);
        const auto [low, high] = std::minmax({cell.values.x, cell.values.y, cell.values.z});
        if (!(high - low <= options_.tolerance)) return {};
        return float(glm::dot(cell.weights, Vec3d(cell.values)));
    }

    const SolidAtlas& solid_;
    const TexelOwners& owners_;
    const ShapeScene& shape_;
    const ShapeMask& mask_;
    const TexelMaskOptions& options_;
    std::optional<SurfaceLattice> lattice_;
};

}  // namespace

TexelField texel_mask(const SolidAtlas& solid, const TexelOwners& owners, const ShapeScene& shape,
                      const ShapeMask& mask, const TexelMaskOptions& options) {
    TexelField field{Image<float>(solid.size, solid.size)};
    if (options.slopes) field.slopes = Image<Vec3f>(solid.size, solid.size);
    const RowMask rows(solid, owners, shape, mask, options);
    for_each_index(
        solid.size, [&](std::size_t y) { rows.fill(y, field); }, 1);
    return field;
}

}  // namespace burl
