#include "app/pipeline/mesh_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>

#include "app/paint/mask.h"
#include "app/surface/normals.h"
#include "atlas/shape/crease_edges.h"
#include "atlas/shape/curvature.h"
#include "atlas/shape/light.h"
#include "atlas/shape/nearest_surface.h"
#include "atlas/shape/occlusion.h"
#include "atlas/shape/point_masks.h"
#include "atlas/shape/texel_mask.h"
#include "atlas/shape/thickness.h"

namespace burl {

namespace {

using ShapePoints = std::span<const ShapePoint>;
using Slopes = std::span<Vec3d>;

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

ShapeMask occlusion_mask(const ShapeScene& scene, const GraphMask& mask) {
    const OcclusionOptions options{int(mask.numbers[0]), mask.numbers[1]};
    return {[&scene, options](ShapePoints points, std::span<float> values) {
        occlusion(scene, points, options, values);
    }};
}

ShapeMask thickness_mask(const ShapeScene& scene, const GraphMask& mask) {
    const ThicknessOptions options{int(mask.numbers[0]), mask.numbers[1]};
    return {[&scene, options](ShapePoints points, std::span<float> values) {
        thickness(scene, points, options, values);
    }};
}

ShapeMask curvature_mask(const ShapeScene& scene, const GraphMask& mask) {
    const auto tree = std::make_shared<const CurvatureTree>(scene);
    return {[tree, radius = mask.numbers[0]](ShapePoints points, std::span<float> values) {
        curvature(*tree, points, radius, values);
    }};
}

ShapeMask edge_mask(const ShapeScene& scene, const GraphMask& mask) {
    const double angle = mask.numbers[0] * std::numbers::pi / 180.0;
    const auto edges = std::make_shared<const CreaseEdges>(scene, angle);
    const double farthest = mask.numbers[1];
    return {[&scene, edges, farthest](ShapePoints points, std::span<float> values) {
                edge_distance(scene, *edges, points, farthest, values);
            },
            [&scene, edges, farthest](ShapePoints points, Slopes slopes) {
                edge_distance_slopes(scene, *edges, points, farthest, slopes);
            }};
}

/// The vector of three of a mask's numbers, of length 1 unless it is 0.
Vec3d unit_of(const GraphMask& mask, std::size_t first) {
    const std::vector<double>& n = mask.numbers;
    const Vec3d direction(n[first], n[first + 1], n[first + 2]);
    const double length = glm::length(direction);
    return length > 0.0 ? direction / length : direction;
}

ShapeMask facing_mask(const ShapeScene& scene, const GraphMask& mask) {
    const Vec3d unit = unit_of(mask, 0);
    return {[unit](ShapePoints points, std::span<float> values) { facing(points, unit, values); },
            [&scene, unit](ShapePoints points, Slopes slopes) {
                facing_slopes(scene, points, unit, slopes);
            }};
}

ShapeMask height_mask(const Mesh& mesh, const GraphMask& mask) {
    const Box3 box = bounding_box(mesh);
    const int axis = int(mask.numbers[0]);
    return {[box, axis](ShapePoints points, std::span<float> values) {
                height_in_box(points, box, axis, values);
            },
            [slope = height_slope(box, axis)](ShapePoints, Slopes slopes) {
                std::ranges::fill(slopes, slope);
            }};
}

/// The mask of a number for each piece, which has no gradient.
ShapeMask part_mask(const Mesh& mesh, const GraphMask& mask) {
    const PieceKind kind = mask.numbers[0] == 1.0 ? PieceKind::part : PieceKind::connected;
    return {[pieces = piece_values(mesh, kind, std::uint64_t(mask.numbers[1]))](
                ShapePoints points, std::span<float> values) {
                std::ranges::transform(points, values.begin(), [&](const ShapePoint& point) {
                    return pieces[point.triangle];
                });
            },
            [](ShapePoints, Slopes slopes) { std::ranges::fill(slopes, Vec3d(0.0)); }};
}

ShapeMask color_mask(const Mesh& mesh, const ShapeScene& scene, std::size_t component) {
    const int c = int(component);
    return {[&mesh, &scene, c](ShapePoints points, std::span<float> values) {
                std::vector<Vec4f> colors(points.size());
                vertex_color(mesh, scene, points, colors);
                std::ranges::transform(colors, values.begin(), [&](const Vec4f& color) {
                    return finite_or_0(double(color[c]), 1e9);
                });
            },
            [&mesh, &scene, c](ShapePoints points, Slopes slopes) {
                vertex_color_slopes(mesh, scene, c, points, slopes);
            }};
}

ShapeMask uv_mask(const Mesh& mesh, const ShapeScene& scene, std::size_t component) {
    const int c = int(component);
    return {[&mesh, &scene, c](ShapePoints points, std::span<float> values) {
                std::vector<Vec2d> uvs(points.size());
                vertex_uv(mesh, scene, points, uvs);
                std::ranges::transform(uvs, values.begin(), [&](const Vec2d& uv) {
                    return finite_or_0(uv[c], farthest_uv);
                });
            },
            [&mesh, &scene, c](ShapePoints points, Slopes slopes) {
                vertex_uv_slopes(mesh, scene, c, points, slopes);
            }};
}

ShapeMask sun_mask(const ShapeScene& scene, const GraphMask& mask) {
    const SunOptions options{unit_of(mask, 5), mask.numbers[8] * std::numbers::pi / 180.0};
    return {[&scene, options](ShapePoints points, std::span<float> values) {
        sun_light(scene, points, options, values);
    }};
}

ShapeMask light_mask(const ShapeScene& scene, const GraphMask& mask) {
    if (is_sun(mask)) return sun_mask(scene, mask);
    const OcclusionOptions options{int(mask.numbers[0]), mask.numbers[1]};
    const SkyHalf half = mask.component == 0 ? SkyHalf::upper : SkyHalf::lower;
    return {[&scene, options, half, up = unit_of(mask, 2)](ShapePoints points,
                                                           std::span<float> values) {
        sky_light(scene, points, up, half, options, values);
    }};
}

ShapeMask shape_mask(const Mesh& mesh, const ShapeScene& scene, const GraphMask& mask) {
    switch (mask.kind) {
        case MaskKind::occlusion:
            return occlusion_mask(scene, mask);
        case MaskKind::curvature:
            return curvature_mask(scene, mask);
        case MaskKind::thickness:
            return thickness_mask(scene, mask);
        case MaskKind::facing:
            return facing_mask(scene, mask);
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
        case MaskKind::paint:  // of solid space, not of the shape
            break;
    }
    return {};
}

/// The length of a mask's features, where it has one of its own.
double feature_length(const GraphMask& mask) {
    if (mask.kind == MaskKind::occlusion || is_sky(mask)) return mask.numbers[1];
    if (mask.kind == MaskKind::curvature) return mask.numbers[0];
    return std::numeric_limits<double>::infinity();
}

/// The values and gradients of a mask times `factor` at the points nearest to positions.
std::vector<Dual> at_nearest(const ShapeScene& scene, const ShapeMask& mask, double factor,
                             double step, std::span<const Vec3d> positions) {
    const NearestSurface nearest(scene);
    std::vector<ShapePoint> points;
    for (const Vec3d& position : positions) points.push_back(nearest(position));
    std::vector<float> values(points.size());
    std::vector<Vec3d> slopes(points.size());
    mask.values(points, values);
    mask_slopes(nearest, mask, points, step, slopes);
    std::vector<Dual> found;
    for (std::size_t i = 0; i < points.size(); ++i)
        found.emplace_back(factor * double(values[i]), factor * slopes[i]);
    return found;
}

std::vector<Vec3d> nearest_points(const ShapeScene& scene, std::span<const Vec3d> positions) {
    const NearestSurface nearest(scene);
    std::vector<Vec3d> points;
    for (const Vec3d& position : positions) points.push_back(nearest(position).position);
    return points;
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
    const double apart = spacing_of(solid, scene, feature_length(mask));
    if (mask.kind == MaskKind::occlusion || is_sky(mask)) return {.spacing = apart};
    if (mask.kind == MaskKind::curvature) return {apart, 0.05f};
    if (mask.kind != MaskKind::thickness) return {.spacing = 0.0};
    return {.tolerance = float(std::min(0.1 * mask.numbers[1], 0.03 * scene.diagonal()))};
}

void multiply(double factor, TexelField& field) {
    for (std::size_t y = 0; y < field.values.height(); ++y)
        for (float& value : field.values.row(y)) value = float(factor * double(value));
    for (std::size_t y = 0; y < field.slopes.height(); ++y)
        for (Vec3f& slope : field.slopes.row(y)) slope = Vec3f(factor * Vec3d(slope));
}

}  // namespace

TexelMaskKey mask_key(const GraphMask& mask, const Recipe& recipe, std::uint32_t size) {
    const double scale = recipe.solid.scale;
    TexelMaskKey key{mask, 1.0, size};
    if (mask.kind == MaskKind::paint) key.strokes = strokes_of(recipe.paint, int(mask.numbers[0]));
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

TexelField MeshShape::light(const SolidAtlas& solid, const TexelOwners& owners,
                            const GraphMask& mask, bool slopes, const std::stop_token& stop) const {
    const ShapeScene scene = scene_->with_normals(corner_normals(mesh_, mask.numbers[9]));
    TexelMaskOptions options = texel_options(solid, scene, mask);
    options.slopes = slopes, options.stop = stop;
    return texel_mask(solid, owners, scene, light_mask(scene, mask), options);
}

TexelField MeshShape::image(const SolidAtlas& solid, const TexelOwners& owners,
                            const TexelMaskKey& key, bool slopes,
                            const std::stop_token& stop) const {
    if (key.mask.kind == MaskKind::lighting) return light(solid, owners, key.mask, slopes, stop);
    TexelMaskOptions options = texel_options(solid, *scene_, key.mask);
    options.slopes = slopes, options.stop = stop;
    TexelField field =
        texel_mask(solid, owners, *scene_, shape_mask(mesh_, *scene_, key.mask), options);
    if (key.factor != 1.0) multiply(key.factor, field);
    return field;
}

std::vector<Dual> MeshShape::at(std::span<const Vec3d> positions, const TexelMaskKey& key) const {
    const GraphMask& mask = key.mask;
    if (mask.kind == MaskKind::paint)
        return paint_mask_at(nearest_points(*scene_, positions), key.strokes);
    const double step = std::min(scene_->diagonal() / 512.0, 0.25 * feature_length(mask));
    if (mask.kind != MaskKind::lighting)
        return at_nearest(*scene_, shape_mask(mesh_, *scene_, mask), key.factor, step, positions);
    const ShapeScene lit = scene_->with_normals(corner_normals(mesh_, mask.numbers[9]));
    return at_nearest(lit, light_mask(lit, mask), key.factor, step, positions);
}

MaskValues masks_at(const MeshShape& shape, const Recipe& recipe, const TextureGraph& graph,
                    std::span<const Vec3d> positions) {
    const Mat3d to_texture = gradients_after(texture_from_solid(recipe));
    MaskValues values;
    for (const GraphMask& mask : graph_masks(graph)) {
        values.push_back(shape.at(positions, mask_key(mask, recipe, 0)));
        for (Dual& one : values.back()) one.slope = to_texture * one.slope;
    }
    return values;
}

}  // namespace burl
