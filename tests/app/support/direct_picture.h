#pragma once
// The ground truth of a recipe on a mesh, without a command line.
#include "app/direct/render.h"
#include "app/surface/normals.h"

namespace burl {

/// Draws the mesh with the recipe's texture and bumps, and the normals of an export.
inline Image<Rgb8> render_direct(const Mesh& mesh, const Recipe& recipe, const Camera& camera,
                                 const PictureOptions& options) {
    const std::vector<Vec3f> normals = corner_normals(mesh, 40.0);
    const Affine3 map = texture_from_mesh(recipe, mesh);
    const FilteredColor color_at = shown_color(recipe, FilterKind::none);
    const SampleColor color = [&](const SurfacePoint& point, const Footprint& steps) {
        return color_at(map(position(mesh, point)), steps);
    };
    return opaque(
        render_samples({mesh, normals, color, bumped_normals(recipe, mesh), {}}, camera, options));
}

}  // namespace burl
