#include "app/pipeline.h"

#include <utility>

#include "app/normals.h"
#include "app/tangents.h"
#include "procedural/synthesize.h"
#include "procedural/synthesize_forward.h"
#include "procedural/synthesize_graph.h"
#include "procedural/synthesize_normals.h"
#include "procedural/synthesize_texels.h"

namespace burl {

Pipeline::Pipeline(Mesh mesh) : mesh_(std::move(mesh)) {}

void Pipeline::set_recipe(const Recipe& recipe) {
    if (recipe.atlas != recipe_.atlas) atlas_.reset();
    if (!atlas_ || recipe.solid.space != recipe_.solid.space) {
        if (synthesizer_) synthesizer_->forget_atlas();
        solid_.reset();
    }
    recipe_ = recipe;
}

template <class Stage>
auto Pipeline::timed(const char* name, Stage&& stage) {
    const auto start = std::chrono::steady_clock::now();
    auto result = stage();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    times_.push_back({name, elapsed.count()});
    return result;
}

const Connectivity& Pipeline::connectivity() {
    if (!connectivity_) {
        connectivity_ = timed("connectivity", [&] { return build_connectivity(mesh_); });
    }
    return *connectivity_;
}

const MeshAtlas& Pipeline::mesh_atlas() {
    if (!atlas_) {
        const Connectivity& edges = connectivity();
        atlas_ = timed("layout", [&] { return build_atlas(mesh_, edges, recipe_.atlas); });
    }
    return *atlas_;
}

const SolidAtlas& Pipeline::solid() {
    if (!solid_) {
        const MeshAtlas& layout = mesh_atlas();
        solid_ = timed("spans", [&] {
            const Affine3 map = solid_from_mesh(mesh_, recipe_.solid.space);
            return rasterize(mesh_, layout, map_positions(layout.mesh(mesh_), map));
        });
    }
    return *solid_;
}

namespace {

PrecisionKind bake_precision(const Recipe& recipe) {
    return recipe.precision.kind.value_or(PrecisionKind::float32);
}

Image<Rgb8> fill(const SolidAtlas& solid, const Recipe& recipe, int threads, Kernel kernel, Rgb8) {
    if (!recipe.graph.empty())
        return synthesize_graph_rgb8(solid, recipe.graph, texture_from_solid(recipe), recipe.filter,
                                     threads, bake_precision(recipe));
    return synthesize_rgb8(solid, recipe.texture, texture_from_solid(recipe), threads,
                           recipe.filter, kernel);
}
Image<Rgb16> fill(const SolidAtlas& solid, const Recipe& recipe, int threads, Kernel kernel,
                  Rgb16) {
    if (!recipe.graph.empty())
        return synthesize_graph_rgb16(solid, recipe.graph, texture_from_solid(recipe),
                                      recipe.filter, threads, bake_precision(recipe));
    return synthesize_rgb16(solid, recipe.texture, texture_from_solid(recipe), threads,
                            recipe.filter, kernel);
}
Image<RgbF> fill(const SolidAtlas& solid, const Recipe& recipe, int threads, Kernel kernel, RgbF) {
    if (!recipe.graph.empty())
        return synthesize_graph_rgbf(solid, recipe.graph, texture_from_solid(recipe), recipe.filter,
                                     threads, bake_precision(recipe));
    return synthesize_rgbf(solid, recipe.texture, texture_from_solid(recipe), threads,
                           recipe.filter, kernel);
}

/// Graphs have both precisions in one place.
bool goes_texel_by_texel(const Recipe& recipe) {
    return recipe.graph.empty() && bake_precision(recipe) != PrecisionKind::float32;
}

ForwardPrecision forward_precision(const Recipe& recipe) {
    return recipe.precision.kind == PrecisionKind::float32 ? ForwardPrecision::float32
                                                           : ForwardPrecision::float64;
}

}  // namespace

template <class Pixel>
Image<Pixel> Pipeline::synthesize() {
    const SolidAtlas& points = solid();
    return timed("synthesis", [&] {
        if (synthesizer_) {
            Image<Pixel> image;
            synthesizer_->synthesize(points, recipe_, threads_, &image);
            return image;
        }
        if (forward_)
            return synthesize_forward<Pixel>(points, recipe_.texture, texture_from_solid(recipe_),
                                             forward_precision(recipe_), threads_);
        if (goes_texel_by_texel(recipe_))
            return synthesize_texels<Pixel>(points, recipe_.texture, texture_from_solid(recipe_),
                                            recipe_.precision, recipe_.filter, threads_);
        return fill(points, recipe_, threads_, kernel_, Pixel{});
    });
}

std::vector<Image<RgbF>> Pipeline::levels(const Image<RgbF>& texture, std::uint32_t count) {
    const MeshAtlas& layout = mesh_atlas();
    return timed("levels", [&] {
        return synthesizer_ ? synthesizer_->levels(layout, texture, count)
                            : block_levels(layout, texture, count);
    });
}

template <class Pixel>
Image<Pixel> Pipeline::normal_map(double crease_degrees, bool tangent_space) {
    const SolidAtlas& points = solid();
    return timed("normals", [&] {
        const Mesh& placed = atlas_mesh();
        const std::vector<Vec3d> positions =
            map_positions(placed, solid_from_mesh(mesh_, recipe_.solid.space));
        const std::vector<Vec3f> normals = corner_normals(placed, crease_degrees);
        std::vector<Vec4f> tangents;
        if (tangent_space)
            tangents =
                corner_tangents(placed.positions, placed.triangles, corner_uvs(atlas()), normals);
        return synthesize_normals<Pixel>(points, {placed, atlas(), positions, normals, tangents},
                                         recipe_.bump, texture_from_solid(recipe_), recipe_.filter,
                                         threads_);
    });
}

template Image<RgbF> Pipeline::normal_map(double, bool);
template Image<Rgb8> Pipeline::normal_map(double, bool);
template Image<Rgb16> Pipeline::normal_map(double, bool);
template Image<Rgb8> Pipeline::synthesize();
template Image<Rgb16> Pipeline::synthesize();
template Image<RgbF> Pipeline::synthesize();

}  // namespace burl
