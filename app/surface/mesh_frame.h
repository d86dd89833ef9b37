#pragma once
// Axes and units of mesh files: --up, --rotate, --scale and --units. Scans and CAD have +z up and
// millimetres, cameras of computer vision -y; glTF and Burl's recipes have +y up and metres. The
// mesh is turned and scaled as it is read, before all else, so that recipes, pictures and the files
// written agree.
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "atlas/base/enum_names.h"
#include "atlas/base/vec.h"
#include "atlas/mesh/mesh.h"
#include "atlas/read/pose.h"

namespace burl {

/// The axes that --up takes; "y" is that of glTF and changes nothing.
inline constexpr std::array<std::string_view, 6> up_axes{"x", "-x", "y", "-y", "z", "-z"};

/// The lengths that a file's 1 may mean.
enum class LengthUnit { mm, cm, m };
template <>
inline constexpr auto enum_names<LengthUnit> = enum_words("mm", "cm", "m");

/// A file's coordinates, as a user tells them.
struct MeshFrame {
    std::string up = "y";               ///< one of up_axes: the axis of the file that points up
    Vec3d rotate{0.0};                  ///< degrees about x, then y, then z, after `up`
    double scale = 1.0;                 ///< a factor above 0
    std::optional<LengthUnit> units{};  ///< none: unknown, and 1 of the file stays 1

    bool operator==(const MeshFrame&) const = default;
};

/// The rotation that brings the axis to +y: by a quarter about x for z (Blender's +x to the right,
/// its front -y towards +z), by a half about x for -y, by a quarter about z for x. All entries are
/// -1, 0 or 1. Throws Error(usage) for another text than one of up_axes.
Mat4d upright(std::string_view axis);

/// The map from the file's coordinates to those of the mesh, +y up, in metres where the units are
/// known: a rotation times one factor, without translation. Quarter turns are exact. Throws
/// Error(usage) for an axis that is not one of up_axes.
Mat4d frame_transform(const MeshFrame& frame);

/// frame_transform() of points. Those of files in mm and cm are divided, so that 9 mm are the
/// double that 0.009 m is.
class FramePoints {
  public:
    explicit FramePoints(const MeshFrame& frame);
    Vec3d operator()(const Vec3d& point) const { return map_ * point / divisor_ + 0.0; }

  private:
    Mat3d map_;
    double divisor_;
};

/// The mesh in the frame: its points, its normals and its placements. A frame whose transform is
/// the identity changes no bit. Throws Error(invalid_file) where a point leaves the range of
/// meshes, 1e100.
Mesh framed(Mesh mesh, const MeshFrame& frame);

/// The pose of a mesh that is framed alike.
MeshPose framed(MeshPose pose, const MeshFrame& frame);

}  // namespace burl
