#include "app/pipeline/texture_color.h"

#include <memory>
#include <utility>

#include "app/pipeline/graph_sampler.h"
#include "procedural/fixed/field.h"
#include "procedural/model/octaves.h"

namespace burl {

TextureColor texture_color(const Recipe& recipe, const Precision& precision) {
    if (!recipe.graph.empty() && precision.kind == PrecisionKind::float32)
        return [graph = std::make_shared<GraphColorSampler>(recipe.graph)](const Vec3d& s) {
            return (*graph)(s);
        };
    if (!recipe.graph.empty()) {
        return [graph = std::make_shared<GraphSampler>(recipe.graph)](const Vec3d& s) {
            return (*graph)(s).color();
        };
    }
    if (precision.kind == PrecisionKind::fixed)
        return [field = FixedField(recipe.texture, precision.format),
                colors = recipe.texture.colors](const Vec3d& s) {
            return evaluate_color(colors, field(s));
        };
    if (precision.kind == PrecisionKind::float32)
        return [octaves = expand_octaves(recipe.texture), quadric = recipe.texture.quadric,
                colors = recipe.texture.colors](const Vec3d& s) {
            return evaluate_color(colors, sample_field<float>(quadric, octaves, s).value);
        };
    return [octaves = expand_octaves(recipe.texture), quadric = recipe.texture.quadric,
            colors = recipe.texture.colors](const Vec3d& s) {
        return evaluate_color(colors, evaluate_field(quadric, octaves, s));
    };
}

SurfaceNormal bumped_normals(const Recipe& recipe, const Mesh& mesh) {
    if (recipe.bump.empty()) return {};
    const Affine3 map = texture_from_mesh(recipe, mesh);
    const double height = recipe.bump.height / solid_units(mesh, recipe.solid.space);
    return [graph = std::make_shared<GraphSampler>(recipe.bump.input), map, height](
               const Vec3d& point, const Vec3d& normal) {
        const Dual node = (*graph)(map(point)).channels[0];
        return bumped_normal(normal, height_gradient(node, height, map.linear));
    };
}

}  // namespace burl
