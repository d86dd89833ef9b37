// Rays go to directions from which equal parts of the light on the plane come. The directions are
// dealt out to the texels of a block, and the blocks' texels averaged (Keller and Heidrich,
// "Interleaved Sampling", 2001), so that neither noise nor copies of the outline are seen.
#include "app/scene/ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "atlas/base/each_index.h"
#include "atlas/shape/ray_tree.h"

namespace burl {

namespace {

constexpr std::size_t texels = 320;  // a side
constexpr std::size_t block = 3;     // texels of a block's side
constexpr std::size_t rays = 48;     // per texel
constexpr double reach = 2.6;        // half the side, in radii of the scene
constexpr double fades_from = 0.55;  // share of the way to the rim

double brightness(const Vec3d& light) {
    return glm::dot(light, Vec3d(0.2126, 0.7152, 0.0722));
}

/// The upper half of an environment in cells of equal angles, with the light that each sends to the
/// plane.
class Sky {
  public:
    explicit Sky(const Environment& environment)
        : rows_(std::clamp<std::size_t>(environment.radiance.height() / 2, 1, most_rows)),
          sums_(4 * rows_ * rows_) {
        const Image<RgbF>& light = environment.radiance;
        for (std::size_t y = 0; y < light.height() / 2; ++y)
            for (std::size_t x = 0; x < light.width(); ++x) add(light, x, y);
        std::partial_sum(sums_.begin(), sums_.end(), sums_.begin());
    }

    bool is_dark() const { return !(sums_.back() > 0.0); }
    /// The direction up to which a share of all light lies; `within` chooses one of its cell.
    Vec3d direction(double share, double within) const {
        const double wanted = share * sums_.back();
        const auto found = std::size_t(std::ranges::upper_bound(sums_, wanted) - sums_.begin());
        const std::size_t cell = std::min(found, sums_.size() - 1);
        const double below = cell > 0 ? sums_[cell - 1] : 0.0, own = sums_[cell] - below;
        const double along = own > 0.0 ? std::clamp((wanted - below) / own, 0.0, 1.0) : 0.5;
        return direction_at({(double(cell % columns()) + along) / double(columns()),
                             (double(cell / columns()) + within) / double(2 * rows_)});
    }

  private:
    static constexpr std::size_t most_rows = 96;

    std::size_t columns() const { return 4 * rows_; }
    void add(const Image<RgbF>& light, std::size_t x, std::size_t y) {
        const RgbF& c = light(x, y);
        const double up = std::numbers::pi * (0.5 - (double(y) + 0.5) / double(light.height()));
        const double weight = std::sin(up) * std::cos(up);
        const std::size_t row = y * 2 * rows_ / light.height(),
                          column = x * columns() / light.width();
        sums_[row * columns() + column] +=
            weight * brightness({double(c.r), double(c.g), double(c.b)});
    }

    std::size_t rows_;
    std::vector<double> sums_;
};

using Directions = std::vector<Vec3f>;

/// Directions from which equal parts of the light come, dealt out to the texels of a block.
std::vector<Directions> light_directions(const Environment& environment) {
    constexpr std::size_t sets = block * block, all = sets * rays;
    const Sky sky(environment);
    std::vector<Directions> directions(sets);
    for (std::size_t i = 0; i < all && !sky.is_dark(); ++i) {
        const double golden = double(i) * std::numbers::phi;
        directions[i % sets].emplace_back(
            sky.direction((double(i) + 0.5) / double(all), golden - std::floor(golden)));
    }
    return directions;
}

/// The triangles that throw shadows, all placements, in coordinates of the ground's square whose
/// side is 1, its middle the origin.
RayTree blockers(const Scene& scene, const Ground& ground) {
    const Vec3d middle = ground.corner + Vec3d(0.5 * ground.side, 0.0, 0.5 * ground.side);
    std::vector<Vec3d> points;
    std::vector<Triangle> triangles;
    for (const Surface& surface : scene.surfaces) {
        if (surface.material.alpha == SceneAlpha::blend) continue;
        for (const Mat4d& placement : surface.placements) {
            const auto first = std::uint32_t(points.size());
            for (std::uint32_t i = 0; i < surface.positions.size(); ++i)
                points.push_back((Vec3d(placement * Vec4d(surface.drawn(i), 1.0)) - middle) /
                                 ground.side);
            for (const Triangle& t : surface.triangles)
                triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
        }
    }
    return {points, triangles};
}

/// 1 in the middle of the square to 0 at the circle that it holds.
double rim(double x, double z) {
    const double r = 2.0 * std::hypot(x, z);
    const double t = std::clamp((1.0 - r) / (1.0 - fades_from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// The share of the directions in which something lies.
float blocked_share(const RayTree& tree, const Directions& directions, double x, double z) {
    if (directions.empty()) return 0.0f;
    // A little below the plane, so that what stands on it blocks.
    const Vec3f origin(float(x), -1e-5f, float(z));
    int blocked = 0;
    for (const Vec3f& direction : directions)
        blocked += tree.blocked({origin, direction}, std::numeric_limits<float>::infinity());
    return float(blocked) / float(directions.size());
}

/// The mean over the block of texels round (x, y); those beyond the image count as 0.
float block_mean(const Image<float>& image, std::size_t x, std::size_t y) {
    constexpr std::size_t half = block / 2;
    float sum = 0.0f;
    for (std::size_t j = y < half ? 0 : y - half; j <= std::min(y + half, image.height() - 1); ++j)
        for (std::size_t i = x < half ? 0 : x - half; i <= std::min(x + half, image.width() - 1);
             ++i)
            sum += image(i, j);
    return sum / float(block * block);
}

/// The lowest y of all drawn points.
double lowest(const Scene& scene) {
    double low = std::numeric_limits<double>::infinity();
    for (const Surface& surface : scene.surfaces)
        for (const Mat4d& placement : surface.placements)
            for (const Triangle& triangle : surface.triangles)
                for (const std::uint32_t vertex : triangle)
                    low = std::min(low, (placement * Vec4d(surface.drawn(vertex), 1.0)).y);
    return low;
}

}  // namespace

Ground ground_under(const Scene& scene, const Environment& environment) {
    const Sphere sphere = bounding_sphere(scene);
    const double half = reach * (sphere.radius > 0.0 ? sphere.radius : 1.0);
    Ground ground{Vec3d(sphere.centre.x - half, lowest(scene), sphere.centre.z - half), 2.0 * half,
                  Image<float>(texels, texels)};
    const RayTree tree = blockers(scene, ground);
    const std::vector<Directions> sets = light_directions(environment);
    const auto place = [](std::size_t i) { return (double(i) + 0.5) / double(texels) - 0.5; };
    Image<float> blocked(texels, texels);
    const auto fill_row = [&](std::size_t row) {
        for (std::size_t column = 0; column < texels; ++column) {
            const Directions& own = sets[row % block * block + column % block];
            if (rim(place(column), place(row)) > 0.0)
                blocked(column, row) = blocked_share(tree, own, place(column), place(row));
        }
    };
    for_each_index(texels, fill_row, 8);
    for (std::size_t row = 0; row < texels; ++row)
        for (std::size_t column = 0; column < texels; ++column)
            ground.shadow(column, row) =
                float(rim(place(column), place(row))) * block_mean(blocked, column, row);
    return ground;
}

Environment white_environment() {
    return {Image<RgbF>(128, 64, RgbF{1.0f, 1.0f, 1.0f})};
}

}  // namespace burl
