#pragma once
// The output of results: a baked image with or without its mesh, in the format of the file name.
// Formats, samplers and the attributes kept of the input: docs/reference/export.md.
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/base/atomic_file.h"
#include "app/image/convert_image.h"
#include "app/image/exr_io.h"
#include "app/image/picture_coding.h"
#include "app/recipe/material.h"
#include "app/recipe/recipe.h"
#include "app/surface/mesh_frame.h"
#include "atlas/mesh/mesh.h"
#include "atlas/mesh/triangle_strips.h"
#include "atlas/read/obj_source.h"
#include "atlas/read/pose.h"
#include "atlas/solid/atlas.h"

namespace burl {

/// A normal map in linear codes (procedural/fill/tangent_frame.h), as large as the texture.
struct NormalMap {
    std::variant<Image<Rgb8>, Image<Rgb16>> image;
    /// Whether normals are in the frames of corner_tangents with the normals of ExportOptions;
    /// otherwise they are in object space, which glTF cannot hold.
    bool tangent_space = true;
    std::vector<std::variant<Image<Rgb8>, Image<Rgb16>>> levels{};  ///< MIP levels 1, 2, ...
};

/// The codes of a picture: colour without or with alpha, or one number per texel.
using PictureImage = std::variant<Image<Rgb8>, Image<Rgb16>, Image<Rgba8>, Image<Rgba16>,
                                  Image<Grey8>, Image<Grey16>>;

/// A picture of a material besides its base colour and its normals.
struct ExportPicture {
    std::string name;                    ///< "orm": the file is NAME_orm.png
    PictureImage image{};                ///< as large as the texture
    std::vector<PictureImage> levels{};  ///< MIP levels 1, 2, ...
    bool is_color = false;               ///< whether codes are sRGB rather than linear
    std::vector<std::string> slots{};    ///< places in a glTF material, as JSON pointers
};

/// A pose of the exported mesh (atlas_pose), and its weight.
struct ExportPose {
    MeshPose corners{};
    double weight = 1.0;  ///< the pose's share, 0..1
};

/// An OBJ of which a scene's .obj keeps what is not changed.
struct KeptObj {
    ObjSource source{};
    MeshFrame frame{};                    ///< leads from its coordinates to the mesh's
    std::vector<std::uint32_t> points{};  ///< points_of_corners()
};

/// The OBJ, a file or a sample, that the mesh was read from and moved by `frame`; null where the
/// path is no OBJ's. Throws Error as read_mesh does, and runtime where the file has changed since.
std::shared_ptr<const KeptObj> kept_obj(const std::string& path, const Mesh& mesh,
                                        const MeshFrame& frame);

/// The material of one of the recipes that share an atlas.
struct ExportShare {
    std::string recipe_name{}, recipe_json{};
    Material material{};       ///< its numbers, factors of what the pictures show
    bool transparent = false;  ///< whether its base colour has alpha
    bool normals = false;      ///< whether it shows the normal map
    std::vector<std::vector<std::string>> slots{};  ///< per picture its places in the glTF material
};

struct ExportOptions {
    /// The crease angle of computed normals (app/surface/normals.h).
    double crease_degrees = 40.0;
    std::string recipe_json{};         ///< the recipe for the glTF's asset.extras; may be empty
    std::string recipe_name{};         ///< the recipe's name, the second part of the material's
    std::vector<BakedImage> levels{};  ///< MIP levels 1, 2, ... (atlas/build/block_levels.h)
    std::optional<NormalMap> normals{};
    /// The material's numbers, which are factors of what its pictures show.
    Material material{};
    std::vector<ExportPicture> pictures{};
    /// The recipes that share the atlas of a glTF's document, each with a material of its own, by
    /// the label of its triangles; empty: there is one recipe.
    std::vector<ExportShare> shares{};
    PictureCoding coding{};               ///< of pictures in and beside the output (coding_asked)
    ExrDepth exr_depth = ExrDepth::half;  ///< of an .exr
    /// The pose becomes a morph target in .glb and .gltf; .obj is written as posed. Images are
    /// those of the mesh at rest.
    std::optional<ExportPose> pose{};
    KeyTrack pose_keys{};  ///< the pose's weight over time; without keys it stays
    /// The OBJ that the mesh was read from, of which an .obj keeps all that is not changed; null:
    /// an .obj has the mesh's triangles alone.
    std::shared_ptr<const KeptObj> obj{};
    /// Per point of the mesh a colour in linear light, which the scene has in place of textures and
    /// texture coordinates; the atlas and the image are empty then. Or empty.
    std::vector<Vec4f> vertex_colors{};
    /// The counts that triangle strips are added to, which .glb, .gltf and .ply have in place of
    /// lists of triangles; null: lists.
    StripCounts* strips = nullptr;
    /// Is told what the format cannot hold or had to be changed; empty: nobody is.
    std::function<void(const std::string&)> tell{};
};

/// All files that scene_files writes, `out_path` first: "a.obj" gives a.obj, a.mtl and a.png,
/// "a.mtlx" these and a.mtlx, and with MIP levels a.1.png, a.2.png, ...; .glb, .exr and .ktx2
/// contain their levels. Normals add a_normal.png and a picture "orm" a_orm.png, with levels of its
/// own, except for .glb; `normal_levels` says whether the normals have levels, too. `format` is
/// that of pictures where the output is none itself. Throws Error(usage) unless the extension is
/// one of .glb, .gltf, .obj, .mtlx, .ply, .stl, .png, .jpg, .jpeg, .webp, .ktx2, .exr (any case),
/// listing them.
std::vector<std::string> output_paths(const std::string& out_path, std::uint32_t levels = 0,
                                      bool normals = false,
                                      const std::vector<std::string>& pictures = {},
                                      bool normal_levels = false,
                                      TextureFormat format = TextureFormat::png);

/// The coding of an output's pictures, asked for by the text of --picture-format; empty: by the
/// output's extension, else PNG. Throws Error(usage) for a wrong text, for another format than that
/// of the output's extension, for KTX2 in glTF and for what is neither PNG nor JPEG in MaterialX.
PictureCoding coding_asked(const std::string& text, const std::string& out_path);

/// The extension that replaces a texture's own for the picture of its MIP level `level` >= 1:
/// ".1.png".
std::string level_extension(std::size_t level, TextureFormat format = TextureFormat::png);

/// The path of the normal map beside an output file of any kind: "a_normal.png" for "a.obj".
std::string normal_map_path(const std::string& out_path, TextureFormat format = TextureFormat::png);

/// All files that scene_files writes of a scene with vertex colours.
std::vector<std::string> paths_without_texture(const std::string& out_path);

/// Whether the format holds triangle strips: .glb, .gltf and .ply. Throws Error(usage) for an
/// unknown extension.
bool holds_strips(const std::string& out_path);

/// Whether the format is .glb or .gltf, whose materials take normal maps in tangent space only.
/// Throws Error(usage) for an unknown extension.
bool is_gltf(const std::string& out_path);
/// Whether the output has an .obj: .obj and .mtlx. Throws Error(usage) for an unknown extension.
bool is_obj(const std::string& out_path);
/// Whether the format is .mtlx. Throws Error(usage) for an unknown extension.
bool is_materialx(const std::string& out_path);

/// Whether the file contains the mesh with its texture, rather than the texture alone. Throws
/// Error(usage) for an unknown extension.
bool holds_mesh(const std::string& out_path);

/// Whether the file contains the mesh with colours, as .stl does not.
bool holds_colors(const std::string& out_path);

/// The kind of images in the output: float for .exr, else 16 bits where `depth` is 16 and 8 bits
/// otherwise.
ImageKind wanted_kind(const std::string& out_path, int depth);

/// Writes all files of an output, which are then committed together by the caller, or none is
/// (app/base/atomic_file.h). `image` is as large as atlas.extent(); it and its levels are of
/// wanted_kind(). Normals in tangent space become part of the
/// material (glTF's normalTexture, with tangents; OBJ's norm), those in object space a file beside
/// it, which .glb and .gltf must not be given. Throws Error: as output_paths, and io when a write
/// fails.
std::vector<AtomicFile> scene_files(const std::string& out_path, const Mesh& mesh,
                                    const Atlas& atlas, const BakedImage& image,
                                    const ExportOptions& options = {});

}  // namespace burl
