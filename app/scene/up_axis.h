#pragma once
// --up: scenes whose up is not +y, turned upright. Scans and CAD have +z up, cameras of computer
// vision -y. Placements are turned, never points, so that solid textures stay where they are on the
// object, bit for bit.
#include <array>
#include <string_view>

#include "atlas/base/vec.h"

namespace burl {

struct Mesh;
struct Scene;

/// The axes that --up takes; "y" is that of glTF and changes nothing.
inline constexpr std::array<std::string_view, 6> up_axes{"x", "-x", "y", "-y", "z", "-z"};

/// The turn of a scene that brings the axis to +y: by a quarter about x for z (Blender's +x to the
/// right, its front -y towards +z), by a half about x for -y, by a quarter about z for x. All
/// entries are -1, 0 or 1. Throws Error(usage) for another text than one of up_axes.
Mat4d upright(std::string_view axis);

/// Turns all placements of the scene, or of the mesh's parts.
void turn(Scene& scene, const Mat4d& rotation);
void turn(Mesh& mesh, const Mat4d& rotation);

}  // namespace burl
