#pragma once
// Colours per point in place of a texture: --vertex-colors.
#include <string>
#include <vector>

#include "app/bake/bake.h"
#include "app/options/command_options.h"

namespace burl {

/// The recipe's colour at each point of the mesh, in linear light with alpha: its exact value, in
/// float64 unless the recipe asks for another precision, without a filter. Throws
/// Error(unsupported) where the recipe reads a mask of the mesh's shape, and as check_lattice does.
std::vector<Vec4f> vertex_colors(const Recipe& recipe, const Mesh& mesh);

/// Throws Error(usage) where the output holds no points with colours, and for options of an atlas,
/// which would do nothing.
void check_vertex_colors(const std::string& out, const RecipeOptions& recipe);

/// The names of all that the recipe has besides numbers and the base colour, which vertex colours
/// do not hold, and of opacity, which those of an .obj do not.
std::vector<std::string> lost_with_vertex_colors(const Recipe& recipe, const std::string& out);

/// Writes the mesh with the colours of its points, and the plan's shader; there is no atlas and no
/// image. Throws Error as vertex_colors() and scene_files() do.
BakeResult bake_vertex_colors(Pipeline& pipeline, const BakePlan& plan, const MeshPose* pose);

}  // namespace burl
