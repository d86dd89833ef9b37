#include "app/measure/metrics_pictures.h"

#include <algorithm>
#include <cmath>

#include "app/direct/render.h"
#include "app/surface/normals.h"
#include "atlas/base/mip_chain.h"
#include "atlas/base/random_unit.h"
#include "atlas/base/sharp_level.h"
#include "atlas/measure/lookup.h"
#include "atlas/solid/weights.h"
#include "procedural/color/srgb.h"

namespace burl {

namespace {

constexpr std::size_t tile = 256;
constexpr std::size_t most_levels = 7;

/// Copies `part` into `picture` with its corner at (x, y).
void paste(const Image<Rgb8>& part, std::size_t x, std::size_t y, Image<Rgb8>& picture) {
    for (std::size_t j = 0; j < part.height(); ++j)
        std::ranges::copy(part.row(j), picture.row(y + j).subspan(x).begin());
}

Image<Rgb8> on_model(const PicturedAtlas& what, std::size_t side, bool lit,
                     const PointColor& color) {
    const PictureSize size{int(side), int(side)};
    const Camera camera = orbit_camera(what.view, bounding_sphere(what.mesh), size);
    return render_points(what.mesh, corner_normals(what.mesh, what.crease_degrees), color, camera,
                         {size, lit, 2});
}

/// The picture of colours per triangle, in the atlas and on the model.
Image<Rgb8> triangles_picture(const PicturedAtlas& what, const std::vector<Vec3d>& colors) {
    const std::size_t texels = what.atlas.options.size;
    const std::size_t side = std::clamp<std::size_t>(texels, 256, 1024);
    Image<Rgb8> texture(texels, texels, encoded(gap_color)), picture(2 * side, side);
    for (std::size_t y = 0; y < texels; ++y)
        for (const Span& span : what.solid.row(y))
            std::ranges::fill(texture.row(y).subspan(span.x, span.count),
                              encoded(colors[what.solid.triangle_of(span.map)]));
    for (std::size_t y = 0; y < side; ++y)
        for (std::size_t x = 0; x < side; ++x)
            picture(x, y) = texture(x * texels / side, y * texels / side);
    const auto color = [&](const SurfacePoint& point) { return colors[point.triangle]; };
    paste(on_model(what, side, true, color), side, 0, picture);
    return picture;
}

double texture_area(const std::array<Vec2d, 3>& c, double size) {
    const Vec2d u = (c[1] - c[0]) / size, v = (c[2] - c[0]) / size;
    return 0.5 * std::abs(u.x * v.y - u.y * v.x);
}

Image<Rgb8> texels_tile(const Image<Vec3f>& level) {
    Image<Rgb8> picture(tile, tile);
    for (std::size_t y = 0; y < tile; ++y)
        for (std::size_t x = 0; x < tile; ++x)
            picture(x, y) =
                encoded(Vec3d(level(x * level.width() / tile, y * level.height() / tile)));
    return picture;
}

/// The first level from `level` on that is no larger than a tile.
const Image<Vec3f>& fitting(const MipChain<Vec3f>& chain, std::size_t level) {
    while (chain.levels[level].width() > tile) ++level;
    return chain.levels[level];
}

}  // namespace

Rgb8 encoded(const Vec3d& linear) {
    const auto code = [](double value) {
        return std::uint8_t(std::lround(255.0 * srgb_encode(std::clamp(value, 0.0, 1.0))));
    };
    return {code(linear.x), code(linear.y), code(linear.z)};
}

Vec3d scale_color(double relative_scale) {
    const Vec3d white(0.85), low(0.02, 0.10, 0.65), high(0.70, 0.03, 0.02);
    if (!(relative_scale > 0.0)) return low;
    const double t = std::clamp(std::log2(relative_scale), -1.0, 1.0);
    return white + std::abs(t) * ((t < 0.0 ? low : high) - white);
}

Vec3d chart_color(std::uint32_t chart) {
    const double hue = 6.0 * std::fmod(0.61803398875 * chart, 1.0);
    const double value = 0.45 + 0.5 * random_unit(7, chart);
    const double low = 0.08 + 0.25 * random_unit(8, chart);
    const auto channel = [&](double shift) {
        const double distance = std::abs(std::fmod(hue + shift, 6.0) - 3.0);
        return value * std::max(low, std::clamp(distance - 1.0, 0.0, 1.0));
    };
    return {channel(0.0), channel(4.0), channel(2.0)};
}

std::vector<double> relative_scales(const Mesh& mesh, const Atlas& atlas) {
    const std::vector<double> areas = triangle_areas(mesh).areas;
    double total = 0.0;
    for (const double area : areas) total += area;
    std::vector<double> scales;
    for (std::size_t t = 0; t < areas.size(); ++t) {
        const double own = texture_area(atlas.corners[t], atlas.options.size);
        scales.push_back(areas[t] > 0.0 ? std::sqrt(own / areas[t] * total) : 1.0);
    }
    return scales;
}

Image<Rgb8> charts_picture(const PicturedAtlas& what, std::span<const std::uint32_t> charts) {
    std::vector<Vec3d> colors;
    for (const std::uint32_t chart : charts) colors.push_back(chart_color(chart));
    return triangles_picture(what, colors);
}

Image<Rgb8> scale_picture(const PicturedAtlas& what) {
    std::vector<Vec3d> colors;
    for (const double scale : relative_scales(what.mesh, what.atlas))
        colors.push_back(scale_color(scale));
    return triangles_picture(what, colors);
}

Image<Rgb8> levels_picture(const PicturedAtlas& what, const TextureValues& texture, bool sharp) {
    MipChain<Vec3f> chain = build_mip_chain(texture.values);
    if (sharp) std::ranges::for_each(chain.levels.begin() + 1, chain.levels.end(), sharpen<Vec3f>);
    const std::size_t count = std::min(most_levels, chain.levels.size());
    Image<Rgb8> picture(count * tile, 2 * tile);
    for (std::size_t l = 0; l < count; ++l) {
        const Image<Vec3f>& level = chain.levels[l];
        const double scale = double(level.width()) / what.atlas.options.size;
        const auto color = [&](const SurfacePoint& point) {
            return bilinear(level, place(what.atlas, point) * scale);
        };
        paste(texels_tile(fitting(chain, l)), l * tile, 0, picture);
        paste(on_model(what, tile, false, color), l * tile, tile, picture);
    }
    return picture;
}

}  // namespace burl
