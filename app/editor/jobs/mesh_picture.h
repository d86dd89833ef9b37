#pragma once
// Small pictures of what a node gives on the object itself: of nodes that read masks, which need a
// mesh and cannot be drawn on a ball.
#include <string>

#include "app/recipe/recipe.h"
#include "app/scene/surface_pick.h"
#include "atlas/base/image.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// A mesh whose nodes are to be drawn.
class MeshPictures {
  public:
    /// The most triangles of a mesh that is drawn so; masks of larger ones take too long.
    static constexpr std::size_t most_triangles = 300000;

    /// Reads the mesh, a file or sample:NAME. Throws Error: unsupported for one of more than
    /// most_triangles, else as load_mesh does.
    explicit MeshPictures(const std::string& path);

    /// Draws the mesh with a recipe's base colour, in the headlight, within the circle that a
    /// picture of side x side pixels holds; the rest is dark. Numbers are greys, from the least to
    /// the largest that is seen where they leave 0 to 1 or hardly differ. Throws Error as
    /// evaluate_points does (app/measure/evaluate_points.h).
    Image<Rgb8> picture(const Recipe& recipe, int side) const;

  private:
    Mesh mesh_;
    SurfacePick pick_;
};

}  // namespace burl
