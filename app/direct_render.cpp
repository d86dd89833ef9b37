#include "app/direct_render.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <tbb/parallel_for.h>

#include "app/normals.h"
#include "app/visibility.h"

namespace burl {

namespace {

constexpr int band_rows = 8;  // picture rows drawn as one task

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
    const Mesh& mesh;
    std::span<const Vec3f> normals;
    const PointColor& color;
    const SurfaceNormal& bumped;
    const Camera& camera;
    bool lit;
};

/// Takes normals through `m`, up to a factor: the inverse transposed times the determinant.
Mat3d cofactors(const Mat3d& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

Vec3d shade(const Surface& surface, const ScreenTriangle& t, const Vec3d& weights) {
    Vec3d point(0.0), normal(0.0);
    for (std::size_t k = 0; k < 3; ++k) {
        const double weight = weights[int(k)];
        point += weight * surface.mesh.positions[surface.mesh.triangles[t.triangle][k]];
        normal += weight * Vec3d(surface.normals[3 * std::size_t(t.triangle) + k]);
    }
    const Vec3d color = surface.color({t.triangle, weights});
    if (!surface.lit) return color;
    const Mat3d to_scene = cofactors(Mat3d(*t.placement));
    const Vec3d to_eye = surface.camera.eye - Vec3d(*t.placement * Vec4d(point, 1.0));
    if (!surface.bumped || normal == Vec3d(0.0))
        return color * headlight(to_scene * normal, to_eye);
    const Vec3d bumped = surface.bumped(point, glm::normalize(normal));
    return color * headlight(to_scene * normal, to_scene * bumped, to_eye);
}

}  // namespace

Image<Rgb8> render_surface(const Mesh& mesh, std::span<const Vec3f> normals,
                           const SurfaceColor& color, const Camera& camera,
                           const PictureOptions& options) {
    const PointColor at = [&](const SurfacePoint& point) { return color(position(mesh, point)); };
    return render_points(mesh, normals, at, camera, options);
}

Image<Rgb8> render_points(const Mesh& mesh, std::span<const Vec3f> normals, const PointColor& color,
                          const Camera& camera, const PictureOptions& options,
                          const SurfaceNormal& bumped) {
    const int n = options.supersample;
    const PictureSize samples{options.size.width * n, options.size.height * n};
    const auto triangles = screen_triangles(mesh, camera, samples);
    const auto bands = sort_into_bands(triangles, samples.height, band_rows * n);
    const Surface surface{mesh, normals, color, bumped, camera, options.lit};
    const Vec3d back = background_linear();
    const RgbF background{float(back.x), float(back.y), float(back.z)};

    const SrgbEncoder<std::uint8_t> encode;
    Image<Rgb8> picture(std::size_t(options.size.width), std::size_t(options.size.height));
    tbb::parallel_for(std::size_t(0), bands.size(), [&](std::size_t band) {
        const int first_row = int(band) * band_rows * n;
        const int rows = std::min(band_rows * n, samples.height - first_row);
        const auto visible =
            visible_triangles(triangles, bands[band], camera, samples.width, first_row, rows);
        Image<RgbF> drawn(std::size_t(samples.width), std::size_t(rows), background);
        for (int j = 0; j < rows; ++j) {
            for (int i = 0; i < samples.width; ++i) {
                const auto x = std::size_t(i), y = std::size_t(j);
                const std::uint32_t index = visible[y * drawn.width() + x];
                if (index == nothing_visible) continue;
                const ScreenTriangle& t = triangles[index];
                const Vec3d c = shade(surface, t, barycentrics(t, i, first_row + j));
                drawn(x, y) = {float(c.x), float(c.y), float(c.z)};
            }
        }
        resolve_samples(drawn, n, encode, picture, 0, band * std::size_t(band_rows));
    });
    return picture;
}

Image<Rgb8> render_direct(const Mesh& mesh, const Recipe& recipe, const Camera& camera,
                          const PictureOptions& options, double crease_degrees) {
    const std::vector<Vec3f> normals = corner_normals(mesh, crease_degrees);
    const Affine3 texture_from_point = texture_from_mesh(recipe, mesh);
    const TextureColor color_at = texture_color(recipe, recipe.precision);
    const PointColor color = [&](const SurfacePoint& point) {
        return color_at(texture_from_point(position(mesh, point)));
    };
    return render_points(mesh, normals, color, camera, options, bumped_normals(recipe, mesh));
}

}  // namespace burl
