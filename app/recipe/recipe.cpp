#include "app/recipe/recipe.h"

#include "procedural/numbers/rotation.h"

namespace burl {

Affine3 texture_from_solid(const Recipe& recipe) {
    const SolidOptions& solid = recipe.solid;
    Affine3 map{solid.scale * Mat3d(1.0), solid.translate};
    if (solid.rotate != Vec3d(0.0)) map.linear = solid.scale * rotation_about_axes(solid.rotate);
    return map;
}

Affine3 texture_from_mesh(const Recipe& recipe, const Mesh& mesh) {
    return texture_from_solid(recipe).after(solid_from_mesh(mesh, recipe.solid.space));
}

PrecisionKind graph_precision(const Recipe& recipe) {
    return recipe.precision.kind == PrecisionKind::float64 ? PrecisionKind::float64
                                                           : PrecisionKind::float32;
}

double solid_units(const Mesh& mesh, SolidSpace space) {
    // The map is a uniform scale without rotation: one diagonal entry is the whole scale.
    return solid_from_mesh(mesh, space).linear[0][0];
}

}  // namespace burl
