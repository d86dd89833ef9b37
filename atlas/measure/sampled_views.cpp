#include "atlas/measure/sampled_views.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <tbb/parallel_for.h>

#include "atlas/base/random_unit.h"
#include "atlas/shape/shape_scene.h"

namespace burl {

namespace {

constexpr std::uint64_t turn_seed = 2000, ray_seed = 3000;
constexpr double reach_in_steps = 2.0;
constexpr int most_turned = 8;  // triangles facing away that a ray passes on its way
constexpr double radian = std::numbers::pi / 180.0;

/// The surface as lines of sight meet it.
class Sight {
  public:
    explicit Sight(const Mesh& mesh) : mesh_(mesh), shape_(mesh) {}

    /// Sets `place` to where the line through `origin` along `towards`, the unit vector to the
    /// camera, meets the surface's front nearest to the origin, on either side; false where it does
    /// not within `reach`.
    bool meet(const Vec3d& origin, const Vec3d& towards, double reach, Vec3d& place) const {
        const double down = first(origin, towards, -1.0, reach);
        const double up = first(origin, towards, 1.0, std::min(reach, std::abs(down)));
        const double nearest = std::abs(up) < std::abs(down) ? up : down;
        if (!std::isfinite(nearest)) return false;
        place = origin + nearest * towards;
        return true;
    }

  private:
    /// The place along `towards` (negative behind the origin) of the first triangle that faces the
    /// camera on the ray to one side; infinite without any.
    double first(const Vec3d& origin, const Vec3d& towards, double side, double reach) const {
        const double slack = 4.0 * ray_offset * shape_.diagonal();
        // A surface through the origin itself lies on both rays.
        double from = -slack;
        for (int passed = 0; passed < most_turned && from < reach; ++passed) {
            const Vec3d start = origin + side * from * towards;
            const ShapeRay ray{Vec3f(shape_.to_unit(start)), Vec3f(side * towards)};
            const std::uint32_t met =
                shape_.rays().nearest(ray, float((reach - from) / shape_.diagonal()));
            if (met == nothing_met) break;
            const Vec3d& normal = shape_.normals()[met];
            const double facing = glm::dot(normal, towards);
            const Vec3d& corner = mesh_.positions[mesh_.triangles[met][0]];
            const double at = side * glm::dot(corner - origin, normal) / facing;
            if (facing > 0.0) return side * at;
            from = (std::isfinite(at) ? std::max(at, from) : from) + slack;
        }
        return std::numeric_limits<double>::infinity();
    }

    const Mesh& mesh_;
    ShapeScene shape_;
};

/// The pixel round one point.
struct Pixel {
    Vec3d centre{0.0};
    PixelSteps steps;
    Vec3d towards{0.0};
};

/// Rays along a pixel's two sides.
struct RayGrid {
    std::uint32_t x = 1, y = 1;
};

/// About rays^2 rays, more along the side that a tilt lengthens.
RayGrid ray_grid(std::uint32_t rays, double cosine) {
    const double across = std::max(1.0, std::round(rays * std::sqrt(cosine)));
    return {std::uint32_t(across), std::uint32_t(std::round(double(rays) * rays / across))};
}

/// The mean over equal parts of the pixel, by a ray at random in each.
Vec3d mean_of(const Sight& sight, const SolidColor& f, const Pixel& pixel, const RayGrid& rays,
              std::uint64_t seed) {
    const double reach = reach_in_steps * glm::length(pixel.steps.y);
    Vec3d sum(0.0);
    std::size_t met = 0;
    for (std::uint32_t j = 0; j < rays.y; ++j)
        for (std::uint32_t i = 0; i < rays.x; ++i) {
            const std::uint64_t counter = 2 * (std::uint64_t{j} * rays.x + i);
            const double a = (i + random_unit(seed, counter)) / rays.x - 0.5;
            const double b = (j + random_unit(seed, counter + 1)) / rays.y - 0.5;
            Vec3d place(0.0);
            if (!sight.meet(pixel.centre + a * pixel.steps.x + b * pixel.steps.y, pixel.towards,
                            reach, place))
                continue;
            sum += f(place);
            ++met;
        }
    return met == 0 ? f(pixel.centre) : sum / double(met);
}

void fill_row(const Mesh& mesh, const Sight& sight, const SolidColor& f, const SampledViews& views,
              const ViewOptions& options, std::size_t number, ViewRow& row) {
    row.means.resize(views.points.size());
    std::vector<double> squares(views.points.size());
    const std::uint64_t row_seed = options.seed + ray_seed + 2 * number;
    const double angle = row.tilt * radian;
    const RayGrid rays = ray_grid(options.rays, std::cos(angle));
    tbb::parallel_for(std::size_t{0}, row.means.size(), [&](std::size_t i) {
        const FootprintAxes& axes = views.axes[i];
        const Vec3d normal = glm::cross(axes.along, axes.across);
        const Pixel pixel{position(mesh, views.points[i]), views.steps(i, row),
                          std::cos(angle) * normal + std::sin(angle) * axes.along};
        const std::uint64_t seed = mix_bits(row_seed) ^ (2 * i);
        const Vec3d one = mean_of(sight, f, pixel, rays, seed);
        const Vec3d other = mean_of(sight, f, pixel, rays, seed + 1);
        squares[i] = mean_square(other - one);
        row.means[i] = 0.5 * (one + other);
    });
    double sum = 0.0;
    for (const double square : squares) sum += square;
    if (!squares.empty()) row.noise = 0.5 * std::sqrt(sum / double(squares.size()));
}

}  // namespace

FootprintAxes random_axes(const Mesh& mesh, std::uint32_t triangle, double turn) {
    const Vec3d normal = face_normal(mesh, triangle);
    const auto& [a, b, c] = mesh.triangles[triangle];
    const auto& p = mesh.positions;
    const Vec3d sides[]{p[b] - p[a], p[c] - p[b], p[a] - p[c]};
    Vec3d side = sides[0];
    for (const Vec3d& s : sides)
        if (glm::dot(s, s) > glm::dot(side, side)) side = s;
    const Vec3d x = glm::normalize(side), y = glm::cross(normal, x);
    const double angle = 2.0 * std::numbers::pi * turn;
    const Vec3d along = std::cos(angle) * x + std::sin(angle) * y;
    return {along, glm::cross(normal, along)};
}

PixelSteps SampledViews::steps(std::size_t i, const ViewRow& row) const {
    const double side = row.minification * texel;
    return {side * axes[i].across, side / std::cos(row.tilt * radian) * axes[i].along};
}

SampledViews sample_views(const Mesh& mesh, const SolidColor& f, double texel,
                          const ViewOptions& options) {
    SampledViews views;
    views.texel = texel;
    views.points = area_uniform_points(mesh, options.points, options.seed + 3);
    for (std::size_t i = 0; i < views.points.size(); ++i)
        views.axes.push_back(
            random_axes(mesh, views.points[i].triangle, random_unit(options.seed + turn_seed, i)));
    if (views.points.empty()) return views;
    const Sight sight(mesh);
    for (const double minification : options.minifications)
        for (const double tilt : options.tilts) {
            ViewRow row{minification, tilt, {}, 0.0};
            fill_row(mesh, sight, f, views, options, views.rows.size(), row);
            views.rows.push_back(std::move(row));
        }
    return views;
}

double view_calls(const ViewOptions& options) {
    double rays = 0.0;
    for (const double tilt : options.tilts) {
        const RayGrid grid = ray_grid(options.rays, std::cos(tilt * radian));
        rays += 2.0 * grid.x * grid.y;
    }
    return rays * double(options.minifications.size()) * double(options.points);
}

}  // namespace burl
