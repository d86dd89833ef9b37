#pragma once
// The places of a mesh's triangles in the glTF that it was read from, for programs that write a
// changed mesh back into its document.
#include <cstdint>
#include <vector>

#include "atlas/base/vec.h"
#include "atlas/file/file_buffer.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// A part of a mesh: one mesh of a glTF in one place.
struct GltfPartOrigin {
    int mesh = 0;
    std::vector<int> nodes;  ///< the nodes that draw the part, which share its triangles
    /// Transform of the part's vertices to the scene, where the mesh's positions are.
    Mat4d to_scene{1.0};
    bool mirrored = false;  ///< whether the second and third corner of triangles are swapped
};

/// A primitive of a part: consecutive triangles.
struct GltfRun {
    std::size_t part = 0;  ///< an index into GltfOrigins::parts and Mesh::parts
    int primitive = 0;
    std::size_t first_triangle = 0, triangle_count = 0;
};

/// Where each triangle of a mesh comes from.
struct GltfOrigins {
    std::vector<GltfPartOrigin> parts;
    std::vector<GltfRun> runs;  ///< in the order of the mesh's triangles, which they cover
    /// Number of the primitive's vertex at each triangle corner (3t+k).
    std::vector<std::uint32_t> vertices;
    bool drops_nodes = false;  ///< whether the choice leaves nodes out that draw the same meshes
};

/// The origins of the triangles of the mesh that read_mesh() makes of the file with the same
/// options. Throws Error as read_mesh() does.
GltfOrigins read_gltf_origins(const FileBuffer& file, const ReadOptions& options = {});

/// A primitive that is read.
struct GltfPrimitive {
    int mesh = 0, primitive = 0;
    std::string mesh_name, material_name;  ///< as globs see them (GltfChoice)
};

/// The triangle primitives that the choice takes from the file's scene, by mesh and primitive, each
/// once. Throws Error as read_mesh() does.
std::vector<GltfPrimitive> chosen_gltf_primitives(const FileBuffer& file,
                                                  const ReadOptions& options = {});

}  // namespace burl
