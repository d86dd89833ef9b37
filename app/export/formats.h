#pragma once
// The writers of formats that scene_files() chooses from, and what they share.
#include <functional>
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
/// The material's name where it is of this recipe.
std::string material_name(const SceneContent& content, const std::string& recipe);

/// An image of a scene: a level of a texture.
struct SceneImage {
    std::string name;                               ///< "teapot marble level 1"
    std::string path;                               ///< of its file, where it has one of its own
    std::function<void(const ByteSink&)> encode{};  ///< writes it as a picture file
};

/// The path of a picture beside an output: "a_orm.png" for "a.obj".
std::string picture_path(const std::string& out_path, const std::string& name,
                         TextureFormat format = TextureFormat::png);

/// The path of a file beside an output, of another extension (with its dot).
std::string path_beside(const std::string& out_path, std::string_view extension);

/// The textures of a scene, each with its MIP levels: the base colour, whose file is `color`, the
/// normal map, if any, and the material's pictures. They refer to the content. A KTX2 holds all
/// levels of its texture and is one image.
std::vector<std::vector<SceneImage>> scene_textures(const SceneContent& content,
                                                    const std::string& color);

/// Adds the picture files of all textures; the base colour's is `color`.
void add_images(std::vector<AtomicFile>& files, const SceneContent& content,
                const std::string& color);

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

/// Writes a MaterialX document of the material beside all that write_obj writes of the mesh; tells
/// what the document leaves out. Throws Error(io).
std::vector<AtomicFile> write_mtlx(const SceneContent& content);

/// Writes the .ply file, binary, in the pose if there is one, and the images beside it. Further
/// placements of a part are copies. Throws Error(io).
std::vector<AtomicFile> write_ply(const SceneContent& content);

/// Writes the surface as a binary .stl file, in the pose if there is one. Throws Error: io, or
/// unsupported for points beyond the range of 32-bit floats.
AtomicFile write_stl(const SceneContent& content);

}  // namespace burl
