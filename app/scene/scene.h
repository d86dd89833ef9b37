#pragma once
// The scene that `burl render` draws: surfaces with per-vertex attributes, base colours and
// placements, as glTF describes them. Independent of OpenGL.
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/scene/camera.h"
#include "app/scene/material.h"
#include "atlas/base/image.h"
#include "atlas/base/vec.h"
#include "atlas/file/file_buffer.h"
#include "atlas/mesh/mesh.h"

namespace burl {

enum class TextureFilter {
    nearest,  ///< the texel that contains the point
    linear,   ///< bilinear at full size
    mip       ///< trilinear: bilinear in two MIP levels and linear between them
};
enum class TextureWrap { repeat, mirror, clamp };

/// A texture with the filter and wrap modes of its file's sampler.
struct SceneTexture {
    Image<Rgb8> image;  ///< sRGB-encoded unless is_color is false; row 0 is v = 0
    TextureFilter filter = TextureFilter::linear;
    TextureWrap wrap_u = TextureWrap::repeat, wrap_v = TextureWrap::repeat;
    /// MIP levels 1, 2, ... from the file; where there are none, box means are computed when
    /// needed.
    std::vector<Image<Rgb8>> levels{};
    bool is_color = true;  ///< false for data in linear codes (normals, numbers)
    /// Alpha of the image and, as many as there are, of its levels; empty where all is opaque.
    Image<Grey8> alpha{};
    std::vector<Image<Grey8>> alpha_levels{};
};

/// The morph target of a surface: changes per vertex, which are scaled by the target's weight.
struct SurfaceTarget {
    std::vector<Vec3d> positions;          ///< changes in local coordinates
    std::vector<Vec3f> normals, tangents;  ///< changes, or empty
};

/// Indexed triangles drawn with one material in one or more placements.
struct Surface {
    std::vector<Vec3d> positions;  ///< local coordinates
    std::vector<Vec3f> normals;    ///< one per position
    std::vector<Vec2d> uvs;        ///< one per position, or empty
    std::vector<Vec4f> tangents;   ///< one per position (procedural/fill/tangent_frame.h), or empty
    std::vector<Vec4f> colors;     ///< linear, one per position, or empty
    /// Per position the rectangle of the texture that it may show (low u, low v, high u, high v),
    /// or empty: lookups of every MIP level are clamped to it.
    std::vector<Vec4f> blocks;
    SurfaceTarget target{};     ///< one entry per position, or empty
    double target_share = 1.0;  ///< the morph target's weight: 0 at rest, 1 at the target
    std::vector<Triangle> triangles;
    SceneMaterial material;
    std::vector<Mat4d> placements{Mat4d(1.0)};  ///< maps from local to scene coordinates

    /// The local position at which vertex `i` is drawn, the morph target included.
    Vec3d drawn(std::uint32_t i) const {
        if (target.positions.empty()) return positions[i];
        return positions[i] + target_share * target.positions[i];
    }
};

struct Scene {
    std::vector<Surface> surfaces;
    std::vector<SceneTexture> textures;
    /// The files read besides the scene's own: buffers, materials, textures.
    std::vector<std::string> files;
    /// Sentences for stderr about differences between file and picture.
    std::vector<std::string> notes;
};

/// Loads a .glb, .gltf or .obj with its materials and textures (PNG, JPEG, WebP). All other files
/// (.ply, .stl, .off) are drawn in vertex colours or grey. A glTF may be drawn in one of its own
/// poses (atlas/gltf/pose.h); empty: as its nodes and weights are stored, skins in their bind pose.
/// Buffers, material libraries and pictures may lie where `named` says.
/// Throws Error: io, invalid_file, unsupported (other formats, KTX textures among them, and more
/// than `most_triangles` to draw, every placement counted), usage for a pose that the file does not
/// have.
Scene load_scene(const std::string& path, const std::string& pose = {},
                 NamedFiles named = NamedFiles::below,
                 std::uint64_t most_triangles = ReadOptions{}.most_triangles);

/// The scene of a glTF file, with materials. Throws Error as load_scene does.
Scene load_gltf_scene(const FileBuffer& file, const std::string& pose = {},
                      std::uint64_t most_triangles = ReadOptions{}.most_triangles);
/// The scene of an OBJ file, with the materials of its libraries. Throws Error as load_scene does.
Scene load_obj_scene(const std::string& path, NamedFiles named = NamedFiles::below,
                     std::uint64_t most_triangles = ReadOptions{}.most_triangles);

/// Computes the tangents (app/surface/tangents.h) of a surface with UVs, and gives each triangle
/// corner a vertex of its own.
void add_tangents(Surface& surface);

/// The linear colour of surfaces without a material.
inline constexpr Vec4f default_grey{0.6f, 0.6f, 0.6f, 1.0f};

/// The scene of a mesh with its own normals, UVs and colours; missing normals are computed with
/// creases at 40 degrees.
Scene scene_from_mesh(const Mesh& mesh, const SceneMaterial& material);

/// The scene of a mesh whose triangle t has the material of number `of_triangle[t]`: a surface for
/// each material of a part.
Scene scene_from_mesh(const Mesh& mesh, std::span<const SceneMaterial> materials,
                      std::span<const std::uint32_t> of_triangle);

/// The bounding sphere of all placed points of triangles, both at rest and at their morph targets,
/// so that a view does not change with the target's weight. Its centre is that of the points' box.
Sphere bounding_sphere(const Scene& scene);

/// Turns all placements of the scene.
void turn(Scene& scene, const Mat4d& turn);

/// The map from [-1,1], in which float32 is precise wherever a surface lies, to the bounding sphere
/// of the surface's positions, of radius 1 where they are one point.
Mat4d unit_frame(const Surface& surface);

/// The unit_frame of every surface of the scene.
std::vector<Mat4d> unit_frames(const Scene& scene);

}  // namespace burl
