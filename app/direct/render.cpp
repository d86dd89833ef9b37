#include "app/direct/render.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <tbb/parallel_for.h>

#include "app/scene/visibility.h"

namespace burl {

namespace {

bool finite(const Vec3d& v) {
    return std::isfinite(v.x + v.y + v.z);
}

constexpr int band_rows = 8;  // picture rows per task

/// Per band of sample rows the triangles that may reach it, in drawing order.
std::vector<std::vector<std::uint32_t>> sort_into_bands(const std::vector<ScreenTriangle>& all,
                                                        int sample_rows, int band_samples) {
    std::vector<std::vector<std::uint32_t>> bands(
        std::size_t((sample_rows + band_samples - 1) / band_samples));
    for (std::uint32_t index = 0; index < all.size(); ++index) {
        const int last = (all[index].y_end - 1) / band_samples;
        for (int band = all[index].y_begin / band_samples; band <= last; ++band) {
            bands[std::size_t(band)].push_back(index);
        }
    }
    return bands;
}

struct Surface {
    const DirectScene& scene;
    const Camera& camera;
    const SampleRays& rays;
    bool lit;
};

/// The cofactors of `m`, which transform normals up to a factor: the inverse transposed times the
/// determinant.
Mat3d cofactors(const Mat3d& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

/// The mesh's colour at sample (x, y), which `t` covers, premultiplied by alpha.
Vec4d shade(const Surface& surface, const ScreenTriangle& t, int x, int y) {
    const Mesh& mesh = surface.scene.mesh;
    const Vec3d weights = barycentrics(t, x, y);
    const auto steps = barycentric_steps(t, x, y, weights);
    Vec3d point(0.0), normal(0.0);
    Footprint covered;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3d& corner = mesh.positions[mesh.triangles[t.triangle][k]];
        point += weights[int(k)] * corner;
        covered.u += steps[0][int(k)] * corner;
        covered.v += steps[1][int(k)] * corner;
        normal += weights[int(k)] * Vec3d(surface.scene.normals[3 * std::size_t(t.triangle) + k]);
    }
    const Vec4d color = surface.scene.color({t.triangle, weights}, covered);
    if (!surface.lit) return color;
    const auto under = [&](double light) { return Vec4d(Vec3d(color) * light, color.w); };
    const Mat3d to_scene = cofactors(Mat3d(*t.placement));
    const Vec3d to_eye = surface.camera.eye - Vec3d(*t.placement * Vec4d(point, 1.0));
    if (!surface.scene.bumped || normal == Vec3d(0.0))
        return under(headlight(to_scene * normal, to_eye));
    const Vec3d bumped = surface.scene.bumped(point, glm::normalize(normal));
    return under(headlight(to_scene * normal, to_scene * bumped, to_eye));
}

struct LayerHit {
    const PlaneLayer* layer;
    PlaneHit at;
};

/// A sample's light from all that is nearer than `depth`, and the share of what lies behind.
struct SampleSum {
    Vec3d light{0.0};
    double shows = 1.0, depth = 0.0;

    bool is_open() const { return shows > 0.0; }
    void add(const Vec4d& color, double light_share = 1.0) {
        light += shows * light_share * Vec3d(color);
        shows *= 1.0 - color.w;
    }
};

/// Collects the planes whose intersections at sample (x, y) are nearer than `depth`, but no nearer
/// than `from`, nearest first.
void find_planes(const Surface& surface, int x, int y, double from, double depth,
                 std::vector<LayerHit>& hits) {
    hits.clear();
    for (const PlaneLayer& layer : surface.scene.planes) {
        const auto hit = meet(surface.rays, x, y, layer.plane);
        if (hit && hit->depth >= from && hit->depth < depth) hits.push_back({&layer, *hit});
    }
    std::stable_sort(hits.begin(), hits.end(),
                     [](const LayerHit& a, const LayerHit& b) { return a.at.depth < b.at.depth; });
}

/// Adds the planes as far as they are seen.
void add_planes(const Surface& surface, std::span<const LayerHit> hits, SampleSum& sum) {
    for (const LayerHit& hit : hits) {
        if (!sum.is_open()) return;
        const Vec4d color = hit.layer->color(hit.at.point, hit.at.steps);
        const double light =
            surface.lit ? headlight(hit.layer->plane.normal, surface.camera.eye - hit.at.point)
                        : 1.0;
        sum.add(color, light);
    }
}

/// Adds what sample (x, y) shows up to the triangle `t`, or up to the background where it is null.
void add_layer(const Surface& surface, const ScreenTriangle* t, int x, int y,
               std::vector<LayerHit>& hits, SampleSum& sum) {
    const double depth =
        t ? depth_of(*t, surface.camera, x, y) : std::numeric_limits<double>::infinity();
    find_planes(surface, x, y, sum.depth, depth, hits);
    add_planes(surface, hits, sum);
    sum.depth = depth;
    if (!sum.is_open()) return;
    sum.add(t ? shade(surface, *t, x, y) : Vec4d(background_linear(), 1.0));
}

/// Some rows of samples of a picture, from `first_row` on.
struct SampleBand {
    std::span<const ScreenTriangle> triangles;
    std::span<const std::uint32_t> candidates;  ///< the triangles that may reach these rows
    int width = 0, first_row = 0, rows = 0;
};

/// Draws the rows: the frontmost triangles, then, where they are transparent, those behind them.
Image<RgbF> draw_band(const Surface& surface, const SampleBand& band) {
    const auto& [triangles, candidates, width, first_row, rows] = band;
    auto front = visible_triangles(triangles, candidates, surface.camera, width, first_row, rows);
    std::vector<SampleSum> sums(front.size());
    std::vector<LayerHit> hits;
    for (bool open = true; open;) {
        open = false;
        for (std::size_t k = 0; k < sums.size(); ++k) {
            if (!sums[k].is_open()) continue;
            const ScreenTriangle* t = front[k] == nothing_visible ? nullptr : &triangles[front[k]];
            add_layer(surface, t, int(k) % width, first_row + int(k) / width, hits, sums[k]);
            if (!sums[k].is_open()) front[k] = nothing_visible;
            open = open || sums[k].is_open();
        }
        if (open)
            front = triangles_behind(front, triangles, candidates, surface.camera, width, first_row,
                                     rows);
    }
    Image<RgbF> drawn{std::size_t(width), std::size_t(rows)};
    for (std::size_t k = 0; k < sums.size(); ++k) {
        const Vec3d& c = sums[k].light;
        drawn(k % drawn.width(), k / drawn.width()) = {float(c.x), float(c.y), float(c.z)};
    }
    return drawn;
}

}  // namespace

SampleRays::SampleRays(const Camera& camera, const PictureSize& samples) : eye_(camera.eye) {
    const Vec3d across = camera.right / camera.focal_x, upwards = camera.up / camera.focal_y;
    steps_ = {2.0 / samples.width * across, -2.0 / samples.height * upwards};
    first_ = -camera.back - across + upwards;
}

Vec3d SampleRays::direction(int x, int y) const {
    return first_ + (x + 0.5) * steps_.u + (y + 0.5) * steps_.v;
}

std::optional<PlaneHit> meet(const SampleRays& rays, int x, int y, const Plane& plane) {
    const Vec3d direction = rays.direction(x, y);
    const double height = plane.offset - glm::dot(plane.normal, rays.eye());
    const double approach = glm::dot(plane.normal, direction);
    // A ray that is parallel within rounding errors counts as parallel.
    if (!(std::abs(approach) > 0x1p-48 * glm::length(direction))) return std::nullopt;
    PlaneHit hit;
    hit.depth = height / approach;
    if (!(hit.depth > 0.0)) return std::nullopt;
    hit.point = rays.eye() + hit.depth * direction;
    const auto moved = [&](const Vec3d& step) {
        return hit.depth * (step - glm::dot(plane.normal, step) / approach * direction);
    };
    hit.steps = {moved(rays.steps().u), moved(rays.steps().v)};
    if (!finite(hit.point) || !finite(hit.steps.u) || !finite(hit.steps.v)) return std::nullopt;
    return hit;
}

Image<Rgb8> render_samples(const DirectScene& scene, const Camera& camera,
                           const PictureOptions& options) {
    const int n = options.supersample;
    const PictureSize samples{options.size.width * n, options.size.height * n};
    const auto triangles = screen_triangles(scene.mesh, camera, samples);
    const auto bands = sort_into_bands(triangles, samples.height, band_rows * n);
    const SampleRays rays(camera, samples);
    const Surface surface{scene, camera, rays, options.lit};

    const SrgbEncoder<std::uint8_t> encode;
    Image<Rgb8> picture(std::size_t(options.size.width), std::size_t(options.size.height));
    tbb::parallel_for(std::size_t(0), bands.size(), [&](std::size_t band) {
        const int first_row = int(band) * band_rows * n;
        const int rows = std::min(band_rows * n, samples.height - first_row);
        const Image<RgbF> drawn =
            draw_band(surface, {triangles, bands[band], samples.width, first_row, rows});
        resolve_samples(drawn, n, encode, picture, 0, band * std::size_t(band_rows));
    });
    return picture;
}

Image<Rgb8> render_points(const Mesh& mesh, std::span<const Vec3f> normals, const PointColor& color,
                          const Camera& camera, const PictureOptions& options) {
    const SampleColor at = [&](const SurfacePoint& point, const Footprint&) {
        return Vec4d(color(point), 1.0);
    };
    return render_samples({mesh, normals, at, {}, {}}, camera, options);
}

}  // namespace burl
