#include "app/pipeline/mesh_shape.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "app/surface/normals.h"
#include "atlas/shape/crease_edges.h"
#include "atlas/shape/curvature.h"
#include "atlas/shape/light.h"
#include "atlas/shape/occlusion.h"
#include "atlas/shape/point_masks.h"
#include "atlas/shape/texel_mask.h"
#include "atlas/shape/thickness.h"

namespace burl {

namespace {

using ShapePoints = std::span<const ShapePoint>;

Mesh moved_mesh(Mesh mesh, const Affine3& map) {
    mesh.positions = map_positions(mesh, map);
    return mesh;
}

bool is_sun(const GraphMask& mask) {
    return mask.kind == MaskKind::lighting && mask.component == 2;
}

bool is_sky(const GraphMask& mask) {
    return mask.kind == MaskKind::lighting && mask.component < 2;
}

float finite_or_0(double value, double largest) {
    return std::isfinite(value) ? float(std::clamp(value, -largest, largest)) : 0.0f;
}

PointMask occlusion_mask(const ShapeScene& scene, const GraphMask& mask) {
    const OcclusionOptions options{int(mask.numbers[0]), mask.numbers[1]};
    return [&scene, options](ShapePoints points, std::span<float> values) {
        occlusion(scene, points, options, values);
    };
}

PointMask thickness_mask(const ShapeScene& scene, const GraphMask& mask) {
    const ThicknessOptions options{int(mask.numbers[0]), mask.numbers[1]};
    return [&scene, options](ShapePoints points, std::span<float> values) {
        thickness(scene, points, options, values);
    };
}

PointMask curvature_mask(const ShapeScene& scene, const GraphMask& mask) {
    const auto tree = std::make_shared<const CurvatureTree>(scene);
    return [tree, radius = mask.numbers[0]](ShapePoints points, std::span<float> values) {
        curvature(*tree, points, radius, values);
    };
}

PointMask edge_mask(const ShapeScene& scene, const GraphMask& mask) {
    const double angle = mask.numbers[0] * std::numbers::pi / 180.0;
    const auto edges = std::make_shared<const CreaseEdges>(scene, angle);
    return
        [&scene, edges, farthest = mask.numbers[1]](ShapePoints points, std::span<float> values) {
            edge_distance(scene, *edges, points, farthest, values);
        };
}

/// The vector of three of a mask's numbers, of length 1 unless it is 0.
Vec3d unit_of(const GraphMask& mask, std::size_t first) {
    const std::vector<double>& n = mask.numbers;
    const Vec3d direction(n[first], n[first + 1], n[first + 2]);
    const double length = glm::length(direction);
    return length > 0.0 ? direction / length : direction;
}

PointMask facing_mask(const GraphMask& mask) {
    return [unit = unit_of(mask, 0)](ShapePoints points, std::span<float> values) {
        facing(points, unit, values);
    };
}

PointMask height_mask(const Mesh& mesh, const GraphMask& mask) {
    return [box = bounding_box(mesh), axis = int(mask.numbers[0])](ShapePoints points,
                                                                   std::span<float> values) {
        height_in_box(points, box, axis, values);
    };
}

PointMask part_mask(const Mesh& mesh, const GraphMask& mask) {
    const PieceKind kind = mask.numbers[0] == 1.0 ? PieceKind::part : PieceKind::connected;
    return [pieces = piece_values(mesh, kind, std::uint64_t(mask.numbers[1]))](
               ShapePoints points, std::span<float> values) {
        std::ranges::transform(points, values.begin(),
                               [&](const ShapePoint& point) { return pieces[point.triangle]; });
    };
}

PointMask color_mask(const Mesh& mesh, const ShapeScene& scene, std::size_t component) {
    return [&mesh, &scene, c = int(component)](ShapePoints points, std::span<float> values) {
        std::vector<Vec4f> colors(points.size());
        vertex_color(mesh, scene, points, colors);
        std::ranges::transform(colors, values.begin(), [&](const Vec4f& color) {
            return finite_or_0(double(color[c]), 1e9);
        });
    };
}

PointMask uv_mask(const Mesh& mesh, const ShapeScene& scene, std::size_t component) {
    return [&mesh, &scene, c = int(component)](ShapePoints points, std::span<float> values) {
        std::vector<Vec2d> uvs(points.size());
        vertex_uv(mesh, scene, points, uvs);
        std::ranges::transform(uvs, values.begin(),
                               [&](const Vec2d& uv) { return finite_or_0(uv[c], farthest_uv); });
    };
}

PointMask sun_mask(const ShapeScene& scene, const GraphMask& mask) {
    const SunOptions options{unit_of(mask, 5), mask.numbers[8] * std::numbers::pi / 180.0};
    return [&scene, options](ShapePoints points, std::span<float> values) {
        sun_light(scene, points, options, values);
    };
}

PointMask light_mask(const ShapeScene& scene, const GraphMask& mask) {
    if (is_sun(mask)) return sun_mask(scene, mask);
    const OcclusionOptions options{int(mask.numbers[0]), mask.numbers[1]};
    const SkyHalf half = mask.component == 0 ? SkyHalf::upper : SkyHalf::lower;
    return [&scene, options, half, up = unit_of(mask, 2)](ShapePoints points,
                                                          std::span<float> values) {
        sky_light(scene, points, up, half, options, values);
    };
}

PointMask point_mask(const Mesh& mesh, const ShapeScene& scene, const GraphMask& mask) {
    switch (mask.kind) {
        case MaskKind::occlusion:
            return occlusion_mask(scene, mask);
        case MaskKind::curvature:
            return curvature_mask(scene, mask);
        case MaskKind::thickness:
            return thickness_mask(scene, mask);
        case MaskKind::facing:
            return facing_mask(mask);
        case MaskKind::height_in_box:
            return height_mask(mesh, mask);
        case MaskKind::edge_distance:
            return edge_mask(scene, mask);
        case MaskKind::part:
            return part_mask(mesh, mask);
        case MaskKind::vertex_color:
            return color_mask(mesh, scene, mask.component);
        case MaskKind::mesh_uv:
            return uv_mask(mesh, scene, mask.component);
        case MaskKind::lighting:
            return light_mask(scene, mask);
    }
    return {};
}

/// The mean side of a texel, in the SolidAtlas's space.
double texel_side(const SolidAtlas& solid, const ShapeScene& scene) {
    double area = 0.0, texels = 1.0;
    for (const double one : scene.areas()) area += one;
    for (const Span& span : solid.spans) texels += double(span.count);
    return scene.diagonal() * std::sqrt(area / texels);
}

/// The distance in texels between the points at which a mask is worked out whose features are as
/// long as `length`: four, but no more than half of that; 0, which is all texels, below one.
double spacing_of(const SolidAtlas& solid, const ShapeScene& scene, double length) {
    const double most = 0.5 * length / texel_side(solid, scene);
    return most >= 1.0 ? std::min(most, 4.0) : 0.0;
}

/// How densely a mask is worked out: those that take rays or integrals are interpolated.
TexelMaskOptions texel_options(const SolidAtlas& solid, const ShapeScene& scene,
                               const GraphMask& mask) {
    if (mask.kind == MaskKind::occlusion || is_sky(mask))
        return {.spacing = spacing_of(solid, scene, mask.numbers[1])};
    if (mask.kind == MaskKind::curvature) return {spacing_of(solid, scene, mask.numbers[0]), 0.05f};
    if (mask.kind != MaskKind::thickness) return {.spacing = 0.0};
    return {.tolerance = float(std::min(0.1 * mask.numbers[1], 0.03 * scene.diagonal()))};
}

}  // namespace

TexelMaskKey mask_key(const GraphMask& mask, double scale, std::uint32_t size) {
    TexelMaskKey key{mask, 1.0, size};
    std::vector<double>& numbers = key.mask.numbers;
    if (mask.kind == MaskKind::curvature) numbers[0] /= scale;
    const bool is_length = mask.kind == MaskKind::thickness || mask.kind == MaskKind::edge_distance;
    if (is_length || mask.kind == MaskKind::occlusion || is_sky(mask)) numbers[1] /= scale;
    // Sky and sun have nothing in common: what decides about the other is left out.
    if (is_sky(mask)) std::fill_n(numbers.begin() + 5, 4, 0.0);
    if (is_sun(mask)) std::fill_n(numbers.begin(), 5, 0.0);
    if (is_length) key.factor = scale;
    return key;
}

MeshShape::MeshShape(Mesh mesh, const Affine3& solid_from_mesh)
    : mesh_(moved_mesh(std::move(mesh), solid_from_mesh)),
      scene_(std::make_unique<ShapeScene>(mesh_)) {}

MeshShape::~MeshShape() = default;

Image<float> MeshShape::light(const SolidAtlas& solid, const GraphMask& mask) const {
    const ShapeScene scene = scene_->with_normals(corner_normals(mesh_, mask.numbers[9]));
    return texel_mask(solid, scene, light_mask(scene, mask), texel_options(solid, scene, mask));
}

Image<float> MeshShape::image(const SolidAtlas& solid, const TexelMaskKey& key) const {
    if (key.mask.kind == MaskKind::lighting) return light(solid, key.mask);
    Image<float> image = texel_mask(solid, *scene_, point_mask(mesh_, *scene_, key.mask),
                                    texel_options(solid, *scene_, key.mask));
    if (key.factor != 1.0)
        for (std::size_t y = 0; y < image.height(); ++y)
            for (float& value : image.row(y)) value = float(key.factor * double(value));
    return image;
}

}  // namespace burl
