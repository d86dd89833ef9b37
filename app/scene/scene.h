#pragma once
// What `burl render` draws: surfaces with per-vertex attributes, base colours, and the places they
// stand in, as a glTF scene has them. Independent of OpenGL.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "app/scene/camera.h"
#include "atlas/base/image.h"
#include "atlas/base/vec.h"
#include "atlas/file/file_buffer.h"
#include "atlas/mesh/mesh.h"

namespace burl {

enum class TextureFilter {
    nearest,  ///< the texel that holds the point
    linear,   ///< bilinear at full size
    mip       ///< bilinear in two MIP levels and linear between them
};
enum class TextureWrap { repeat, mirror, clamp };

/// A base colour texture and how the file wants it looked up.
struct SceneTexture {
    Image<Rgb8> image;  ///< sRGB-encoded; row 0 is v = 0
    TextureFilter filter = TextureFilter::linear;
    TextureWrap wrap_u = TextureWrap::repeat, wrap_v = TextureWrap::repeat;
    /// MIP levels 1, 2, ... the file brings; without any, box means are made where needed.
    std::vector<Image<Rgb8>> levels{};
    bool is_color = true;  ///< false: linear codes (normals)
};

struct SceneMaterial {
    Vec4f factor{1.0f};  ///< linear, times the texture's colour; alpha is not drawn
    int texture = -1;    ///< index into Scene::textures, -1: white
    int normals = -1;    ///< the same of a normal map in tangent space, -1: none
    float normal_scale = 1.0f;
};

/// Where a surface's vertices go: what is added to each, times the share of the way gone.
struct SurfaceTarget {
    std::vector<Vec3d> positions;          ///< local
    std::vector<Vec3f> normals, tangents;  ///< or empty
};

/// Indexed triangles drawn with one material at one or more places.
struct Surface {
    std::vector<Vec3d> positions;  ///< local
    std::vector<Vec3f> normals;    ///< one per position
    std::vector<Vec2d> uvs;        ///< one per position, or empty
    std::vector<Vec4f> tangents;   ///< one per position (procedural/fill/tangent_frame.h), or empty
    std::vector<Vec4f> colors;     ///< linear, one per position, or empty
    /// Per position the part of the texture it may show (low u, low v, high u, high v), or empty:
    /// lookups of every MIP level are clamped to it.
    std::vector<Vec4f> blocks;
    SurfaceTarget target{};     ///< one of each per position, or empty
    double target_share = 1.0;  ///< of the target's way that is gone
    std::vector<Triangle> triangles;
    SceneMaterial material;
    std::vector<Mat4d> placements{Mat4d(1.0)};  ///< scene from local

    /// Where vertex `i` is drawn, local.
    Vec3d drawn(std::uint32_t i) const {
        if (target.positions.empty()) return positions[i];
        return positions[i] + target_share * target.positions[i];
    }
};

struct Scene {
    std::vector<Surface> surfaces;
    std::vector<SceneTexture> textures;
    std::vector<std::string> files;  ///< read besides the one named: buffers, materials, textures
    std::vector<std::string> notes;  ///< what is drawn otherwise than the file says, for stderr
};

/// Loads .glb or .gltf with its PNG textures. Of an .obj with one material, Kd, map_Kd and norm are
/// used. Everything else (.ply, .stl, .off, .obj with several materials) is drawn in its vertex
/// colours or grey. Throws Error: io, invalid_file, unsupported (other formats; JPEG, WebP or KTX
/// textures).
Scene load_scene(const std::string& path);

/// The two halves of load_scene that know materials.
Scene load_gltf_scene(const FileBuffer& file);
Scene load_obj_scene(const std::string& path);

/// Gives a surface with UVs tangents (app/surface/tangents.h), and each corner a vertex of its own.
void add_tangents(Surface& surface);

/// What surfaces without a material look like.
inline constexpr Vec4f default_grey{0.6f, 0.6f, 0.6f, 1.0f};

/// The mesh with its own normals, UVs and colours, else normals with creases at 40 degrees.
Scene scene_from_mesh(const Mesh& mesh, const SceneMaterial& material);

/// Sphere around the centre of the box of all placed points that triangles use, both as they are
/// and, so that views stay the same on the way, as their target has them; as bounding_sphere(Mesh).
Sphere bounding_sphere(const Scene& scene);

}  // namespace burl
