#include "atlas/shape/texel_mask.h"

#include <algorithm>
#include <optional>

#include "atlas/base/each_index.h"

namespace burl {

namespace {

/// Fills rows one by one, from the lattice where that is smooth, else by the mask itself.
class RowMask {
  public:
    RowMask(const SolidAtlas& solid, const ShapeScene& shape, const PointMask& mask,
            const TexelMaskOptions& options)
        : solid_(solid), shape_(shape), mask_(mask), tolerance_(options.tolerance) {
        if (options.spacing > 0.0) lattice_.emplace(solid, shape, mask, options.spacing);
    }

    void fill(std::size_t y, std::span<float> row) const {
        std::vector<std::uint32_t> places;
        std::vector<ShapePoint> points;
        for (const Span& span : solid_.row(y)) {
            const TexelMap& map = solid_.maps[span.map];
            const std::uint32_t triangle = solid_.triangle_of(span.map);
            for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
                const Vec3d weights = shape_.weights_at(triangle, map(x, std::int64_t(y)));
                if (const auto value = interpolated(triangle, weights)) {
                    row[x] = *value;
                } else {
                    places.push_back(x);
                    points.push_back(shape_.surface_point(triangle, weights));
                }
            }
        }
        std::vector<float> values(points.size());
        mask_(points, values);
        for (std::size_t i = 0; i < places.size(); ++i) row[places[i]] = values[i];
    }

  private:
    std::optional<float> interpolated(std::uint32_t triangle, const Vec3d& weights) const {
        if (!lattice_ || !lattice_->covers(triangle)) return {};
        const LatticeCell cell = lattice_->at(triangle, weights);
        const auto [low, high] = std::minmax({cell.values.x, cell.values.y, cell.values.z});
        if (!(high - low <= tolerance_)) return {};
        return float(glm::dot(cell.weights, Vec3d(cell.values)));
    }

    const SolidAtlas& solid_;
    const ShapeScene& shape_;
    const PointMask& mask_;
    float tolerance_;
    std::optional<SurfaceLattice> lattice_;
};

}  // namespace

Image<float> texel_mask(const SolidAtlas& solid, const ShapeScene& shape, const PointMask& mask,
                        const TexelMaskOptions& options) {
    Image<float> image(solid.size, solid.size);
    const RowMask rows(solid, shape, mask, options);
    for_each_index(
        solid.size, [&](std::size_t y) { rows.fill(y, image.row(y)); }, 1);
    return image;
}

}  // namespace burl
