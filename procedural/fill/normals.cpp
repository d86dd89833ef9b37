#include "procedural/fill/normals.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "atlas/solid/texel_owners.h"
#include "procedural/fill/graph_texels.h"
#include "procedural/fill/pieces.h"
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

/// The surface's interpolated vectors at a point of a texel; 0 where there are none.
struct SurfaceVectors {
    Vec3d normal{0.0}, tangent{0.0};
    double sign = 1.0;  ///< of the bitangent
};

/// Interpolates the vectors of triangles' corners at texels.
class SurfaceAt {
  public:
    SurfaceAt(const SolidAtlas& solid, const ShadingFrames& frames)
        : solid_(solid), owners_(solid, frames.atlas, OwnerReach::lookups), frames_(frames) {}

    /// The vectors of a point u and v texels from the texel's centre.
    SurfaceVectors operator()(const TexelPlace& texel, double u, double v) const {
        const TexelMap& map = solid_.maps[texel.map];
        const Vec3d point = map(texel.x, texel.y) + u * map.step_x + v * map.step_y;
        const std::size_t t = owners_(texel.x, texel.y, texel.map);
        const Triangle& corners = frames_.mesh.triangles[t];
        const auto& p = frames_.positions;
        const Vec3d weights = inside_weights(p[corners[0]], p[corners[1]], p[corners[2]], point);
        SurfaceVectors vectors{interpolated(frames_.normals, t, weights)};
        if (frames_.tangents.empty()) return vectors;
        vectors.tangent = interpolated(frames_.tangents, t, weights);
        vectors.sign = double(frames_.tangents[3 * t].w);
        return vectors;
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
};

/// The shader of normal maps: the bumped normal at a sample.
class BumpShade {
  public:
    BumpShade(const SolidAtlas& solid, const ShadingFrames& frames, const Bump& bump,
              const Affine3& texture_from_atlas)
        : surface_(solid, frames),
          in_object_space_(frames.tangents.empty()),
          bump_(bump),
          map_(texture_from_atlas) {}

    Vec3d operator()(const TexelPlace& texel, double u, double v, const GraphSample& height) const {
        const SurfaceVectors at = surface_(texel, u, v);
        if (at.normal == Vec3d(0.0)) return {0.0, 0.0, 1.0};
        const Vec3d gradient = height_gradient(height.channels[0], bump_.height, map_.linear);
        if (in_object_space_) return bumped_normal(glm::normalize(at.normal), gradient);
        if (at.tangent == Vec3d(0.0)) return {0.0, 0.0, 1.0};
        const TangentFrame frame = tangent_frame(at.normal, at.tangent, at.sign);
        return in_frame(frame, bumped_normal(frame.normal, gradient));
    }

  private:
    SurfaceAt surface_;
    bool in_object_space_;
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

/// Gives the map to take(first, image) in bands of rows.
template <class Pixel, class Take>
void fill_bands(const SolidAtlas& solid, const ShadingFrames& frames, const Bump& bump,
                const Affine3& texture_from_atlas, const Filter& filter, int threads,
                PrecisionKind precision, const MaskImages& masks, const Economy& economy,
                std::size_t rows, const Take& take) {
    check_masks(bump.input, GraphOutput::color, masks, solid.size);
    const NormalEncoder<Pixel> encode{};
    const GraphEvaluator evaluate(bump.input, filter, precision);
    const BumpShade shade(solid, frames, bump, texture_from_atlas);
    // Finding the texels' owners takes a tenth of the time; the pace is that of what follows.
    if (TaskMeter* const meter = economy.meter)
        meter->begin(meter->read().task, texels_of(solid, 0, solid.size), true);
    for (std::size_t first = 0; first < solid.size; first += rows) {
        const std::size_t count = std::min<std::size_t>(rows, solid.size - first);
        Image<Pixel> image(solid.size, count, encode({0.0, 0.0, 1.0}));
        fill_texels(solid, texture_from_atlas, evaluate, filter, shade, encode, threads,
                    RowBand(image, first), economy, masks);
        take(first, std::move(image));
        if (economy.stop.stop_requested()) return;
    }
}

}  // namespace

template <class Pixel>
Image<Pixel> synthesize_normals(const SolidAtlas& solid, const ShadingFrames& frames,
                                const Bump& bump, const Affine3& texture_from_atlas,
                                const Filter& filter, int threads, PrecisionKind precision,
                                const MaskImages& masks, const Economy& economy) {
    Image<Pixel> whole;
    fill_bands<Pixel>(solid, frames, bump, texture_from_atlas, filter, threads, precision, masks,
                      economy, solid.size,
                      [&](std::size_t, Image<Pixel> rows) { whole = std::move(rows); });
    return whole;
}

void synthesize_normals_in_bands(const SolidAtlas& solid, const ShadingFrames& frames,
                                 const Bump& bump, const Affine3& texture_from_atlas,
                                 const Filter& filter, int threads, PrecisionKind precision,
                                 const MaskImages& masks, const Economy& economy, std::size_t rows,
                                 const TakeNormals& take) {
    fill_bands<RgbF>(solid, frames, bump, texture_from_atlas, filter, threads, precision, masks,
                     economy, rows, take);
}

FrameMaps frame_maps(const SolidAtlas& solid, const ShadingFrames& frames, int threads) {
    const SurfaceAt surface(solid, frames);
    FrameMaps maps{Image<RgbaF>(solid.size, solid.size), Image<RgbaF>(solid.size, solid.size)};
    const auto fill = [&](std::uint32_t x, std::uint32_t y, std::uint32_t map) {
        const SurfaceVectors at = surface({x, y, map, {}, {}}, 0.0, 0.0);
        if (at.normal == Vec3d(0.0) || at.tangent == Vec3d(0.0)) return;
        const Vec3f n(glm::normalize(at.normal)), t(glm::normalize(at.tangent));
        maps.normals(x, y) = {n.x, n.y, n.z, float(at.sign)};
        maps.tangents(x, y) = {t.x, t.y, t.z, 0.0f};
    };
    for_row_ranges(solid.size, std::size_t(1) << 14, threads, [&](const RowRange& rows) {
        for (std::size_t y = rows.begin(); y != rows.end(); ++y)
            for (const Span& span : solid.row(std::uint32_t(y)))
                for (std::uint32_t x = span.x; x < span.x + span.count; ++x)
                    fill(x, std::uint32_t(y), span.map);
    });
    return maps;
}

template Image<Rgb8> synthesize_normals(const SolidAtlas&, const ShadingFrames&, const Bump&,
                                        const Affine3&, const Filter&, int, PrecisionKind,
                                        const MaskImages&, const Economy&);
template Image<Rgb16> synthesize_normals(const SolidAtlas&, const ShadingFrames&, const Bump&,
                                         const Affine3&, const Filter&, int, PrecisionKind,
                                         const MaskImages&, const Economy&);
template Image<RgbF> synthesize_normals(const SolidAtlas&, const ShadingFrames&, const Bump&,
                                        const Affine3&, const Filter&, int, PrecisionKind,
                                        const MaskImages&, const Economy&);

}  // namespace burl
