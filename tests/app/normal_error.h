#pragma once
// How far the normals that a viewer makes of a baked map are from the recipe's own.
#include <algorithm>
#include <cmath>
#include <vector>

#include "app/normals.h"
#include "app/pipeline.h"
#include "app/tangents.h"
#include "app/texture_color.h"
#include "atlas/bilinear.h"
#include "atlas/surface_points.h"
#include "procedural/tangent_frame.h"

namespace burl {

inline double degrees_between(const Vec3d& a, const Vec3d& b) {
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

struct NormalErrors {
    double mean = 0.0, percentile99 = 0.0, largest = 0.0;  ///< degrees
    double mean_tilt = 0.0;  ///< of the exact normals against the unbumped ones
};

inline Image<Vec3f> components(const Image<RgbF>& map) {
    Image<Vec3f> result(map.width(), map.height());
    for (std::size_t y = 0; y < map.height(); ++y)
        for (std::size_t x = 0; x < map.width(); ++x)
            result(x, y) = {map(x, y).r, map(x, y).g, map(x, y).b};
    return result;
}

/// As a viewer decodes them: lookups interpolate the codes, which is the same up to scale.
template <class Code>
Image<Vec3f> components(const Image<Rgb<Code>>& map) {
    Image<Vec3f> result(map.width(), map.height());
    const float largest = float(std::numeric_limits<Code>::max());
    for (std::size_t y = 0; y < map.height(); ++y)
        for (std::size_t x = 0; x < map.width(); ++x) {
            const Rgb<Code>& c = map(x, y);
            result(x, y) = 2.0f / largest * Vec3f(float(c.r), float(c.g), float(c.b)) - 1.0f;
        }
    return result;
}

/// The atlas's mesh with the frames a viewer interpolates.
struct ViewerFrames {
    const Mesh& mesh;
    std::vector<Vec3f> normals;
    std::vector<Vec4f> tangents;

    explicit ViewerFrames(Pipeline& pipeline)
        : mesh(pipeline.atlas_mesh()),
          normals(corner_normals(mesh, 40.0)),
          tangents(corner_tangents(mesh.positions, mesh.triangles, corner_uvs(pipeline.atlas()),
                                   normals)) {}

    Vec3d normal(const SurfacePoint& p) const {
        Vec3d n(0.0);
        for (int k = 0; k < 3; ++k)
            n += p.weights[k] * Vec3d(normals[3 * std::size_t(p.triangle) + std::size_t(k)]);
        return glm::normalize(n);
    }
    TangentFrame frame(const SurfacePoint& p) const {
        Vec3d t(0.0);
        for (int k = 0; k < 3; ++k)
            t += p.weights[k] * Vec3d(tangents[3 * std::size_t(p.triangle) + std::size_t(k)]);
        return tangent_frame(normal(p), t, double(tangents[3 * std::size_t(p.triangle)].w));
    }
};

/// `map` in tangent space, looked up bilinearly at `count` points spread over the surface.
inline NormalErrors normal_errors(Pipeline& pipeline, const Image<Vec3f>& map,
                                  const ViewerFrames& frames, std::size_t count) {
    const SurfaceNormal exact = bumped_normals(pipeline.recipe(), pipeline.mesh());
    NormalErrors errors;
    std::vector<double> all;
    for (const SurfacePoint& p : area_uniform_points(frames.mesh, count, 1)) {
        const Vec3d normal = frames.normal(p);
        const Vec3d wanted = exact(position(frames.mesh, p), normal);
        const Vec3d seen = from_frame(frames.frame(p), bilinear(map, place(pipeline.atlas(), p)));
        all.push_back(degrees_between(wanted, seen));
        errors.mean += all.back() / double(count);
        errors.mean_tilt += degrees_between(wanted, normal) / double(count);
    }
    std::sort(all.begin(), all.end());
    errors.percentile99 = all[all.size() * 99 / 100];
    errors.largest = all.back();
    return errors;
}

}  // namespace burl
