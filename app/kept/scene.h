#pragma once
// A glTF that is baked back into its own document.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/kept/carve.h"

namespace burl {

/// A document on its way from one file to another. Several bakes may carve it one after the other;
/// files are committed with the last.
struct KeptScene {
    explicit KeptScene(const FileBuffer& file) : document(file) {}

    KeptDocument document;
    GltfOrigins origins{};                  ///< of the mesh that is baked next
    Mat4d frame{1.0};                       ///< transform of the whole scene
    std::optional<std::uint32_t> uv_set{};  ///< as in CarvedMesh
    std::string pictures{};                 ///< as in CarvedMesh
    std::vector<std::uint32_t> labels{};    ///< as in CarvedMesh
    bool is_last = true;                    ///< whether no other bake follows
    bool is_strict = false;                 ///< whether a loss is an error
    std::vector<AtomicFile> pending{};
};

/// Whether a bake of the mesh file to the output keeps the document of the mesh: both are glTF.
bool keeps_document(const std::string& mesh_path, const std::string& out_path);

/// The document of the mesh file, whose own files may lie where `named` says. Throws Error as
/// load_gltf() does.
std::shared_ptr<KeptScene> kept_scene(const std::string& mesh_path,
                                      NamedFiles named = NamedFiles::below);

/// Makes the scene ready for a bake of the mesh that is read with `options` and then moved by
/// `frame`, which a new root node of the document says; pictures beside a .gltf are named after
/// `pictures`. Throws Error as read_mesh() does.
void prepare(KeptScene& scene, const std::string& mesh_path, const ReadOptions& options,
             const std::string& pictures, const Mat4d& frame = Mat4d(1.0));

/// Carves the scene's document. Returns all its files where this is the last bake, else none.
/// Throws Error as carve() and write_kept() do, and unsupported for a loss where the scene is
/// strict.
std::vector<AtomicFile> kept_files(KeptScene& scene, const SceneContent& content,
                                   std::span<const CornerOrigin> corners);

/// Whether a bake of the mesh file, or sample, to the output keeps the mesh's own lines: both are
/// OBJ.
bool keeps_lines(const std::string& mesh_path, const std::string& out_path);

/// Names of all in the file of the mesh that an output with the mesh alone does not hold; of a
/// sample, the triangles that are not chosen. `keeps_uvs` says whether the output has the file's
/// texture coordinates, where that is no glTF.
std::vector<std::string> losses_of_flat(const std::string& mesh_path, const Mesh& mesh,
                                        const std::string& out_path, bool keeps_uvs);

/// The loss of every bake in an .stl.
inline constexpr const char* stl_loss = "colours, of which an .stl has none";

/// One sentence that names losses.
std::string losses_sentence(const std::vector<std::string>& losses);

}  // namespace burl
