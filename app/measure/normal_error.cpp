#include "app/measure/normal_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/pipeline/texture_color.h"
#include "app/surface/normals.h"
#include "app/surface/tangents.h"
#include "atlas/measure/lookup.h"

namespace burl {

namespace {

double degrees_between(const Vec3d& a, const Vec3d& b) {
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

template <class Corner>
Vec3d interpolated(const std::vector<Corner>& corners, const SurfacePoint& p) {
    Vec3d sum(0.0);
    for (int k = 0; k < 3; ++k)
        sum += p.weights[k] * Vec3d(corners[3 * std::size_t(p.triangle) + std::size_t(k)]);
    return sum;
}

template <class Pixel, class Decode>
Image<Vec3f> decoded(const Image<Pixel>& map, const Decode& decode) {
    Image<Vec3f> result(map.width(), map.height());
    for (std::size_t y = 0; y < map.height(); ++y)
        for (std::size_t x = 0; x < map.width(); ++x) result(x, y) = decode(map(x, y));
    return result;
}

}  // namespace

ViewerFrames ViewerFrames::of(Pipeline& pipeline, double crease_degrees) {
    const Mesh& mesh = pipeline.atlas_mesh();
    std::vector<Vec3f> normals = corner_normals(mesh, crease_degrees);
    std::vector<Vec4f> tangents =
        corner_tangents(mesh.positions, mesh.triangles, corner_uvs(pipeline.atlas()), normals);
    return {mesh, std::move(normals), std::move(tangents)};
}

Vec3d ViewerFrames::normal(const SurfacePoint& p) const {
    return glm::normalize(interpolated(normals, p));
}

TangentFrame ViewerFrames::frame(const SurfacePoint& p) const {
    return tangent_frame(interpolated(normals, p), interpolated(tangents, p),
                         double(tangents[3 * std::size_t(p.triangle)].w));
}

Image<Vec3f> components(const NormalMap& map) {
    return std::visit(
        [](const auto& image) {
            return decoded(image, []<class Code>(const Rgb<Code>& c) {
                const float largest = float(std::numeric_limits<Code>::max());
                return 2.0f / largest * Vec3f(float(c.r), float(c.g), float(c.b)) - 1.0f;
            });
        },
        map.image);
}

Image<Vec3f> components(const Image<RgbF>& map) {
    return decoded(map, [](const RgbF& c) { return Vec3f(c.r, c.g, c.b); });
}

NormalErrors normal_errors(Pipeline& pipeline, const ViewerFrames& frames, const Image<Vec3f>& map,
                           bool tangent_space, std::size_t count) {
    const SurfaceNormal exact = bumped_normals(pipeline.recipe(), pipeline.mesh());
    NormalErrors errors;
    std::vector<double> all;
    for (const SurfacePoint& p : area_uniform_points(frames.mesh, count, 1)) {
        const Vec3d normal = frames.normal(p);
        const Vec3d wanted = exact(position(frames.mesh, p), normal);
        const Vec3d found = bilinear(map, place(pipeline.atlas(), p));
        const Vec3d seen = tangent_space ? from_frame(frames.frame(p), found) : found;
        const double error = degrees_between(wanted, seen);
        // The corners' vectors cancel: no viewer has a frame here.
        if (!std::isfinite(error)) continue;
        all.push_back(error);
        errors.mean += error;
        errors.mean_tilt += degrees_between(wanted, normal);
    }
    if (all.empty()) return errors;
    errors.mean /= double(all.size());
    errors.mean_tilt /= double(all.size());
    std::sort(all.begin(), all.end());
    errors.percentile99 = all[all.size() * 99 / 100];
    errors.largest = all.back();
    return errors;
}

}  // namespace burl
