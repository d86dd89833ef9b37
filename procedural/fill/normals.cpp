#include "procedural/fill/normals.h"

#include <cstdint>

#include "atlas/solid/texel_owners.h"
#include "procedural/fill/graph_texels.h"
#include "procedural/fill/tangent_frame.h"

namespace burl {

namespace {

/// Barycentric weights of p's projection onto triangle abc, clamped to the triangle, because texels
/// of gutters and overscan lie beyond it. Equal weights for a triangle without area.
Vec3d inside_weights(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& p) {
    const Vec3d u = b - a, v = c - a, normal = glm::cross(u, v);
    const double area2 = glm::dot(normal, normal);
    if (!(area2 > 0.0)) return Vec3d(1.0 / 3.0);
    const double to_b = glm::dot(glm::cross(p - a, v), normal) / area2;
    const double to_c = glm::dot(glm::cross(u, p - a), normal) / area2;
    const Vec3d kept = glm::max(Vec3d(1.0 - to_b - to_c, to_b, to_c), Vec3d(0.0));
    return kept / (kept.x + kept.y + kept.z);
}

/// The shader of normal maps: the bumped normal at a sample.
class BumpShade {
  public:
    BumpShade(const SolidAtlas& solid, const ShadingFrames& frames, const Bump& bump,
              const Affine3& texture_from_atlas)
        : solid_(solid),
          owners_(solid, frames.atlas, OwnerReach::lookups),
          frames_(frames),
          bump_(bump),
          map_(texture_from_atlas) {}

    Vec3d operator()(const TexelPlace& texel, double u, double v, const GraphSample& height) const {
        const TexelMap& map = solid_.maps[texel.map];
        const Vec3d point = map(texel.x, texel.y) + u * map.step_x + v * map.step_y;
        const std::size_t t = owners_(texel.x, texel.y, texel.map);
        const Triangle& corners = frames_.mesh.triangles[t];
        const auto& p = frames_.positions;
        const Vec3d weights = inside_weights(p[corners[0]], p[corners[1]], p[corners[2]], point);
        const Vec3d normal = interpolated(frames_.normals, t, weights);
        if (normal == Vec3d(0.0)) return {0.0, 0.0, 1.0};
        const Vec3d gradient = height_gradient(height.channels[0], bump_.height, map_.linear);
        if (frames_.tangents.empty()) return bumped_normal(glm::normalize(normal), gradient);
        const Vec3d tangent = interpolated(frames_.tangents, t, weights);
        if (tangent == Vec3d(0.0)) return {0.0, 0.0, 1.0};
        const TangentFrame frame =
            tangent_frame(normal, tangent, double(frames_.tangents[3 * t].w));
        return in_frame(frame, bumped_normal(frame.normal, gradient));
    }

  private:
    template <class Vector>
    static Vec3d interpolated(std::span<const Vector> corners, std::size_t t,
                              const Vec3d& weights) {
        Vec3d sum(0.0);
        for (int k = 0; k < 3; ++k) sum += weights[k] * Vec3d(corners[3 * t + std::size_t(k)]);
        return sum;
    }

    const SolidAtlas& solid_;
    TexelOwners owners_;
    const ShadingFrames& frames_;
    const Bump& bump_;
    const Affine3& map_;
};

/// The mean of unit vectors scaled to length 1; (0, 0, 1) for a mean of 0.
Vec3d unit(const Vec3d& mean) {
    const double length = glm::length(mean);
    return length > 0.0 ? mean / length : Vec3d(0.0, 0.0, 1.0);
}

template <class Pixel>
struct NormalEncoder;

template <class Code>
struct NormalEncoder<Rgb<Code>> {
    Rgb<Code> operator()(const Vec3d& mean) const { return encode_normal<Code>(unit(mean)); }
};

template <>
struct NormalEncoder<RgbF> {
    RgbF operator()(const Vec3d& mean) const {
        const Vec3d n = unit(mean);
        return {float(n.x), float(n.y), float(n.z)};
    }
};

}  // namespace

template <class Pixel>
Image<Pixel> synthesize_normals(const SolidAtlas& solid, const ShadingFrames& frames,
                                const Bump& bump, const Affine3& texture_from_atlas,
                                const Filter& filter, int threads, PrecisionKind precision,
                                const MaskImages& masks) {
    check_masks(bump.input, GraphOutput::color, masks, solid.size);
    const NormalEncoder<Pixel> encode{};
    const GraphEvaluator evaluate(bump.input, filter, precision);
    const BumpShade shade(solid, frames, bump, texture_from_atlas);
    Image<Pixel> image(solid.size, solid.size, encode({0.0, 0.0, 1.0}));
    fill_texels(solid, texture_from_atlas, evaluate, filter, shade, encode, threads, RowBand(image),
                {}, masks);
    return image;
}

template Image<Rgb8> synthesize_normals(const SolidAtlas&, const ShadingFrames&, const Bump&,
                                        const Affine3&, const Filter&, int, PrecisionKind,
                                        const MaskImages&);
template Image<Rgb16> synthesize_normals(const SolidAtlas&, const ShadingFrames&, const Bump&,
                                         const Affine3&, const Filter&, int, PrecisionKind,
                                         const MaskImages&);
template Image<RgbF> synthesize_normals(const SolidAtlas&, const ShadingFrames&, const Bump&,
                                        const Affine3&, const Filter&, int, PrecisionKind,
                                        const MaskImages&);

}  // namespace burl
