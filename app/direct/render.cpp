#include "app/direct/render.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <tbb/parallel_for.h>

#include "app/direct/mesh_sample.h"
#include "app/direct/traced_sample.h"
#include "app/scene/visibility.h"
#include "atlas/base/random_unit.h"

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

struct Drawing {
    const DirectScene& scene;
    const Camera& camera;
    const SampleRays& rays;
    const PictureOptions& options;
};

/// The directions of a layer of sample (x, y).
LightDraw draw_of(const Drawing& drawing, int x, int y, std::size_t layer) {
    const int n = drawing.options.supersample;
    const auto pixel = (std::uint64_t(std::uint32_t(y / n)) << 32) | std::uint32_t(x / n);
    return {mix_bits(mix_bits(pixel) + 4 * layer), y % n * n + x % n};
}

/// The mesh's colour at a sample under the headlight, premultiplied by alpha.
Vec4d headlit(const Drawing& drawing, const ScreenTriangle& t, const MeshSample& sample) {
    const Vec4d color = drawing.scene.color({t.triangle, sample.weights}, sample.covered);
    if (!drawing.options.lit) return color;
    const auto under = [&](double light) { return Vec4d(Vec3d(color) * light, color.w); };
    const Mat3d to_scene = cofactors(Mat3d(*t.placement));
    const Vec3d to_eye = drawing.camera.eye - Vec3d(*t.placement * Vec4d(sample.point, 1.0));
    if (!drawing.scene.bumped || sample.normal == Vec3d(0.0))
        return under(headlight(to_scene * sample.normal, to_eye));
    const Vec3d bumped = drawing.scene.bumped(sample.point, glm::normalize(sample.normal));
    return under(headlight(to_scene * sample.normal, to_scene * bumped, to_eye));
}

/// The mesh's colour at sample (x, y), which `t` covers, premultiplied by alpha.
Vec4d shade(const Drawing& drawing, const ScreenTriangle& t, int x, int y, std::size_t layer) {
    const MeshSample sample = mesh_sample(drawing.scene, t, x, y);
    if (!drawing.scene.around.light) return headlit(drawing, t, sample);
    return traced(drawing.scene, t, sample, {drawing.camera.eye, draw_of(drawing, x, y, layer)});
}

struct LayerHit {
    const PlaneLayer* layer;
    PlaneHit at;
};

/// A sample's light from all that is nearer than `depth`, and the share of what lies behind.
struct SampleSum {
    Vec3d light{0.0};
    double shows = 1.0, depth = 0.0;
    std::size_t layers = 0;

    bool is_open() const { return shows > 0.0; }
    void add(const Vec4d& color, double light_share = 1.0) {
        light += shows * light_share * Vec3d(color);
        shows *= 1.0 - color.w;
        ++layers;
    }
};

/// Collects the planes whose intersections at sample (x, y) are nearer than `depth`, but no nearer
/// than `from`, nearest first.
void find_planes(const Drawing& drawing, int x, int y, double from, double depth,
                 std::vector<LayerHit>& hits) {
    hits.clear();
    for (const PlaneLayer& layer : drawing.scene.planes) {
        const auto hit = meet(drawing.rays, x, y, layer.plane);
        if (hit && hit->depth >= from && hit->depth < depth) hits.push_back({&layer, *hit});
    }
    std::stable_sort(hits.begin(), hits.end(),
                     [](const LayerHit& a, const LayerHit& b) { return a.at.depth < b.at.depth; });
}

/// Adds the planes as far as they are seen.
void add_planes(const Drawing& drawing, std::span<const LayerHit> hits, int x, int y,
                SampleSum& sum) {
    for (const LayerHit& hit : hits) {
        if (!sum.is_open()) return;
        if (drawing.scene.around.light) {
            sum.add(traced(drawing.scene, *hit.layer, hit.at.point, hit.at.steps,
                           {drawing.camera.eye, draw_of(drawing, x, y, sum.layers)}));
            continue;
        }
        const Vec4d color = hit.layer->color(hit.at.point, hit.at.steps);
        const double light = drawing.options.lit ? headlight(hit.layer->plane.normal,
                                                             drawing.camera.eye - hit.at.point)
                                                 : 1.0;
        sum.add(color, light);
    }
}

/// The shadow on the ground at sample (x, y): black, with the share that it hides.
Vec4d ground_shadow(const Drawing& drawing, int x, int y) {
    const DirectSurroundings& around = drawing.scene.around;
    const std::optional<double> low = around.blockers->lowest();
    if (!low || drawing.camera.eye.y <= *low) return Vec4d(0.0);
    const auto hit = meet(drawing.rays, x, y, {{0.0, 1.0, 0.0}, *low});
    if (!hit) return Vec4d(0.0);
    // A little below the plane, so that what stands on it blocks.
    const Vec3d place = hit->point - Vec3d(0.0, around.blockers->offset(), 0.0);
    return {0.0, 0.0, 0.0, around.on_ground->shadow(place, draw_of(drawing, x, y, 0))};
}

/// Adds the ground and what lies behind all else, but for a colour that is put there last.
void add_surroundings(const Drawing& drawing, int x, int y, SampleSum& sum) {
    const DirectSurroundings& around = drawing.scene.around;
    if (around.on_ground) sum.add(ground_shadow(drawing, x, y));
    if (around.backdrop)
        sum.add(Vec4d(light_from(*around.backdrop, drawing.rays.direction(x, y)), 1.0));
}

/// Adds what sample (x, y) shows up to the triangle `t`, or up to the background where it is null;
/// returns whether anything more may be seen.
bool add_layer(const Drawing& drawing, const ScreenTriangle* t, int x, int y,
               std::vector<LayerHit>& hits, SampleSum& sum) {
    const double depth =
        t ? depth_of(*t, drawing.camera, x, y) : std::numeric_limits<double>::infinity();
    find_planes(drawing, x, y, sum.depth, depth, hits);
    add_planes(drawing, hits, x, y, sum);
    sum.depth = depth;
    if (!sum.is_open()) return false;
    if (!t) {
        add_surroundings(drawing, x, y, sum);
        return false;
    }
    sum.add(shade(drawing, *t, x, y, sum.layers));
    return sum.is_open();
}

/// Some rows of samples of a picture, from `first_row` on.
struct SampleBand {
    std::span<const ScreenTriangle> triangles;
    std::span<const std::uint32_t> candidates;  ///< the triangles that may reach these rows
    int width = 0, first_row = 0, rows = 0;
};

/// Draws the rows: the frontmost triangles, then, where they are transparent, those behind them.
/// Alpha is the share that hides a background that is put there last.
Image<RgbaF> draw_band(const Drawing& drawing, const SampleBand& band) {
    const auto& [triangles, candidates, width, first_row, rows] = band;
    auto front = visible_triangles(triangles, candidates, drawing.camera, width, first_row, rows);
    std::vector<SampleSum> sums(front.size());
    std::vector<bool> done(front.size());
    std::vector<LayerHit> hits;
    for (bool open = true; open;) {
        open = false;
        for (std::size_t k = 0; k < sums.size(); ++k) {
            if (done[k]) continue;
            const ScreenTriangle* t = front[k] == nothing_visible ? nullptr : &triangles[front[k]];
            done[k] =
                !add_layer(drawing, t, int(k) % width, first_row + int(k) / width, hits, sums[k]);
            if (done[k]) front[k] = nothing_visible;
            open = open || !done[k];
        }
        if (open)
            front = triangles_behind(front, triangles, candidates, drawing.camera, width, first_row,
                                     rows);
    }
    Image<RgbaF> drawn{std::size_t(width), std::size_t(rows)};
    for (std::size_t k = 0; k < sums.size(); ++k) {
        const Vec3d& c = sums[k].light;
        drawn(k % drawn.width(), k / drawn.width()) = {float(c.x), float(c.y), float(c.z),
                                                       float(1.0 - sums[k].shows)};
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

Image<Rgba8> render_samples(const DirectScene& scene, const Camera& camera,
                            const PictureOptions& options) {
    const int n = options.supersample;
    const PictureSize samples{options.size.width * n, options.size.height * n};
    const auto triangles = screen_triangles(scene.mesh, camera, samples);
    const auto bands = sort_into_bands(triangles, samples.height, band_rows * n);
    const SampleRays rays(camera, samples);
    const Drawing drawing{scene, camera, rays, options};

    const SrgbEncoder<std::uint8_t> encode;
    Image<Rgba8> picture(std::size_t(options.size.width), std::size_t(options.size.height));
    tbb::parallel_for(std::size_t(0), bands.size(), [&](std::size_t band) {
        const int first_row = int(band) * band_rows * n;
        const int rows = std::min(band_rows * n, samples.height - first_row);
        const Image<RgbaF> drawn =
            draw_band(drawing, {triangles, bands[band], samples.width, first_row, rows});
        resolve_samples(drawn, options, encode, picture, 0, band * std::size_t(band_rows));
    });
    return picture;
}

Image<Rgb8> opaque(const Image<Rgba8>& picture) {
    return converted<Rgb8>(picture, [](const Rgba8& c) { return Rgb8{c.r, c.g, c.b}; });
}

Image<Rgb8> render_points(const Mesh& mesh, std::span<const Vec3f> normals, const PointColor& color,
                          const Camera& camera, const PictureOptions& options) {
    const SampleColor at = [&](const SurfacePoint& point, const Footprint&) {
        return Vec4d(color(point), 1.0);
    };
    return opaque(render_samples({mesh, normals, at, {}, {}}, camera, options));
}

}  // namespace burl
