#pragma once
// The writers of formats that scene_files() chooses from, and what they share.
#include <string>
#include <vector>

#include "app/base/atomic_file.h"
#include "app/export/export.h"

namespace burl {

/// The content of a scene's file with the files beside it.
struct SceneContent {
    std::string path;
    const Mesh& mesh;
    const Atlas& atlas;
    const BakedImage& image;  ///< of 8 or 16 bits
    const ExportOptions& options;
};

/// The material's name "teapot marble", which differs between textures, since importers merge what
/// has one name.
std::string material_name(const SceneContent& content);

/// Encodes an image of 8 or 16 bits, or a normal map, as the content of a PNG file.
void encode_png(const BakedImage& image, const ByteSink& sink);
void encode_png(const NormalMap& normals, const ByteSink& sink);

/// Adds the PNG files of the normal map, of the MIP levels NAME.1.png, NAME.2.png, ..., and of the
/// texture, at `texture`.
void add_images(std::vector<AtomicFile>& files, const SceneContent& content,
                const std::string& texture);

/// Writes one .glb file, images last. Throws Error: io, or unsupported for more than 4 GiB and for
/// points beyond the range of 32-bit floats.
AtomicFile write_glb(const SceneContent& content);

/// Writes the .gltf file, its buffer NAME.bin and the images. Throws Error: io, or unsupported for
/// points beyond the range of 32-bit floats.
std::vector<AtomicFile> write_gltf(const SceneContent& content);

/// Writes the .obj file, in the pose if there is one, its material NAME.mtl and the images. Faces
/// are in the mesh's order, `v` in the shortest form that reads back to the same double, `vt` with
/// v upwards. Further placements of a part are copies, since OBJ has no instances. Throws
/// Error(io).
std::vector<AtomicFile> write_obj(const SceneContent& content);

}  // namespace burl
