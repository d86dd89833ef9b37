#include "app/pipeline/texture_color.h"

#include <memory>
#include <utility>

#include "app/pipeline/graph_sampler.h"
#include "procedural/fixed/field.h"
#include "procedural/model/octaves.h"

namespace burl {

TextureColor texture_color(const Recipe& recipe, const Precision& precision) {
    const Texture* texture = plain_texture(recipe.texture);
    if (!texture && precision.kind == PrecisionKind::float32)
        return [graph = std::make_shared<GraphColorSampler>(recipe.texture)](const Vec3d& s) {
            return (*graph)(s);
        };
    if (!texture) {
        return [graph = std::make_shared<GraphSampler>(recipe.texture)](const Vec3d& s) {
            return (*graph)(s).color();
        };
    }
    if (precision.kind == PrecisionKind::fixed)
        return [field = FixedField(*texture, precision.format), colors = texture->colors](
                   const Vec3d& s) { return evaluate_color(colors, field(s)); };
    if (precision.kind == PrecisionKind::float32)
        return [octaves = expand_octaves(*texture), quadric = texture->quadric,
                colors = texture->colors](const Vec3d& s) {
            return evaluate_color(colors, sample_field<float>(quadric, octaves, s).value);
        };
    return [octaves = expand_octaves(*texture), quadric = texture->quadric,
            colors = texture->colors](const Vec3d& s) {
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
