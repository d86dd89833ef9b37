#include "app/editor/jobs/mesh_picture.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "app/measure/evaluate_points.h"
#include "app/scene/shading.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"
#include "procedural/color/srgb.h"

namespace burl {

namespace {

constexpr Rgb8 beside{0x58, 0x5c, 0x66};
constexpr double least_contrast = 0.25;  // of numbers that are shown as they are

Mesh small_mesh(const std::string& path) {
    Mesh mesh = load_mesh(path);
    if (mesh.triangles.size() > MeshPictures::most_triangles)
        throw Error(ExitCode::unsupported, "the mesh is too large for pictures of its masks");
    return mesh;
}

/// A pixel that shows the mesh, and the headlight's share there.
struct SeenPixel {
    std::size_t x = 0, y = 0;
    double light = 1.0;
};

bool is_number(const Evaluation& result) {
    const Vec3d color = result.color.value_or(Vec3d(0.0));
    return color == Vec3d(result.value);
}

/// Stretches numbers from their least to their largest value where they are no greys.
void stretch(std::vector<Vec3d>& colors) {
    const auto [low, high] = std::ranges::minmax(colors, {}, &Vec3d::x);
    const bool grey = low.x >= 0.0 && high.x <= 1.0 && high.x - low.x > least_contrast;
    if (grey || !(high.x > low.x)) return;
    for (Vec3d& color : colors) color = Vec3d((color.x - low.x) / (high.x - low.x));
}

}  // namespace

MeshPictures::MeshPictures(const std::string& path)
    : mesh_(small_mesh(path)),
      pick_(std::make_shared<const Scene>(scene_from_mesh(mesh_, SceneMaterial{}))) {}

Image<Rgb8> MeshPictures::picture(const Recipe& recipe, int side) const {
    const PictureSize size{side, side};
    const Camera camera = orbit_camera({30.0, 20.0, 3.1}, bounding_sphere(pick_.scene()), size);
    const Affine3 solid = solid_from_mesh(mesh_, recipe.solid.space);
    PointFile points;
    std::vector<SeenPixel> seen;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const Ray ray = ray_through(camera, size, {x + 0.5, y + 0.5});
            const auto hit = pick_.meet(ray);
            if (!hit) continue;
            const Vec3d p = solid(hit->mesh_point);
            points.points.push_back({p.x, p.y, p.z, 0.0});
            seen.push_back(
                {std::size_t(x), std::size_t(y), headlight(pick_.normal(*hit), -ray.direction)});
        }
    const auto pixels = std::size_t(side);
    Image<Rgb8> picture(pixels, pixels, beside);
    const std::vector<PointResult> results = evaluate_points(recipe, points, &mesh_);
    std::vector<Vec3d> colors;
    for (const PointResult& one : results) colors.push_back(one.float64.color.value_or(Vec3d(0.0)));
    const bool numbers =
        std::ranges::all_of(results, [](const PointResult& one) { return is_number(one.float64); });
    if (numbers && !colors.empty()) stretch(colors);
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const auto code = [&](double v) {
            return std::uint8_t(255.0 * srgb_encode(std::clamp(v * seen[i].light, 0.0, 1.0)) + 0.5);
        };
        picture(seen[i].x, seen[i].y) = {code(colors[i].x), code(colors[i].y), code(colors[i].z)};
    }
    return picture;
}

}  // namespace burl
