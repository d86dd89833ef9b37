#pragma once
// The one door for results: a baked image with or without its mesh, in the format the file name
// asks for. Formats, samplers and what is kept of the input: docs/reference/export.md.
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/base/atomic_file.h"
#include "app/image/exr_io.h"
#include "atlas/base/image.h"
#include "atlas/mesh/mesh.h"
#include "atlas/read/pose.h"
#include "atlas/solid/atlas.h"

namespace burl {

enum class ImageKind { rgb8, rgb16, rgb_float };

/// In the order of ImageKind. 8 and 16 bit are sRGB-encoded, float is linear light.
using BakedImage = std::variant<Image<Rgb8>, Image<Rgb16>, Image<RgbF>>;

/// Normals as linear codes (procedural/fill/tangent_frame.h), as large as the texture.
struct NormalMap {
    std::variant<Image<Rgb8>, Image<Rgb16>> image;
    /// In the frames of corner_tangents with the normals of ExportOptions; false: in the mesh's own
    /// directions, which no glTF can hold.
    bool tangent_space = true;
};

/// Of the exported mesh (atlas_pose), and how far it has gone there.
struct ExportPose {
    MeshPose corners{};
    double weight = 1.0;  ///< 0 to 1
};

struct ExportOptions {
    double crease_degrees = 40.0;         ///< for computed normals (app/surface/normals.h)
    ExrDepth exr_depth = ExrDepth::half;  ///< .exr only
    std::string recipe_json{};            ///< kept in the glTF's asset.extras; may be empty
    std::string recipe_name{};            ///< the material is called after the mesh and it
    std::vector<BakedImage> levels{};     ///< MIP levels 1, 2, ... (atlas/build/block_levels.h)
    std::optional<NormalMap> normals{};
    /// .glb and .gltf get it as a morph target, .obj is written as posed; images are those of the
    /// mesh at rest.
    std::optional<ExportPose> pose{};
};

/// Refuses a picture or report before any work starts: its name ends in `extension` (in lower case;
/// empty: any; else Error(usage)), its folder is writable, and it is none of the `taken` files,
/// which are read (else Error(io)).
void check_side_output(const std::string& path, std::string_view extension,
                       std::span<const std::string> taken);

/// Every file export_scene writes, the one named first: "a.obj" gives a.obj, a.mtl and a.png, and
/// with MIP levels a.1.png, a.2.png, ...; .glb and .exr hold their levels themselves. With normals
/// a_normal.png besides, but for .glb. Throws Error(usage) unless the extension is one of .glb,
/// .gltf, .obj, .png, .exr (any case), listing them.
std::vector<std::string> output_paths(const std::string& out_path, std::uint32_t levels = 0,
                                      bool normals = false);

/// Whether the format's materials can name a normal map in tangent space only.
bool is_gltf(const std::string& out_path);

/// Whether the file is the mesh with its texture, not the texture alone. Throws Error(usage) for an
/// unknown extension.
bool holds_mesh(const std::string& out_path);

/// Which image export_scene wants for this file: float for .exr, 16 bits where `depth` is 16, else
/// 8. Depth is 8 or 16 (for .exr it is not looked at).
ImageKind wanted_kind(const std::string& out_path, int depth);

/// Makes all files of an output, which have yet to be committed together. `image` is as large as
/// atlas.extent(); another kind than the wanted one is converted (float is clamped and
/// sRGB-encoded; 8 and 16 bits are decoded for .exr). Normals in tangent space become part of the
/// material (glTF's normalTexture, with tangents; OBJ's norm), any other ones a file beside; a .glb
/// or .gltf must not be given those. Throws Error: as output_paths, and io when a write fails.
std::vector<AtomicFile> scene_files(const std::string& out_path, const Mesh& mesh,
                                    const Atlas& atlas, const BakedImage& image,
                                    const ExportOptions& options = {});

/// Writes all of them or nothing (app/base/atomic_file.h), and says what was written. Throws Error
/// as scene_files does.
std::vector<CommittedFile> export_scene(const std::string& out_path, const Mesh& mesh,
                                        const Atlas& atlas, const BakedImage& image,
                                        const ExportOptions& options = {});

}  // namespace burl
