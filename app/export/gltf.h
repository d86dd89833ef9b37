#pragma once
// glTF 2.0 files. The JSON and buffers are written here rather than by a library, so that the
// texture is a plain bufferView (not a data URI), bounds are those of the floats written, and every
// byte goes through AtomicFile.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/base/atomic_file.h"
#include "app/base/file_bytes.h"
#include "app/export/vertices.h"
#include "atlas/mesh/mesh.h"
#include "atlas/solid/atlas.h"

namespace burl {

/// The name and weight of the vertices' morph target.
struct GltfTarget {
    std::string name{};
    double weight = 0.0;  ///< the initial weight, 0..1
};

/// The content of a glTF file; images are contents of PNG files.
struct GltfContent {
    std::string path;  ///< the file's path, which errors name
    const Mesh& mesh;
    std::span<const PartVertices> vertices;
    const AtlasOptions& atlas;
    std::string name;  ///< the material's name, and the beginning of the images' names
    ByteSource png;
    std::span<const ByteSource> levels;  ///< PNG contents of MIP levels 1, 2, ...
    std::string recipe_json;             ///< the recipe for asset.extras; may be empty
    /// The normal map in tangent space, for vertices with tangents; may be empty.
    ByteSource normal_png{};
    GltfTarget target{};  ///< the name and weight of morph targets
};

/// Writes one .glb file, images last, which the caller commits. Throws Error: io, or unsupported
/// for more than 4 GiB and for points beyond the range of 32-bit floats.
AtomicFile write_glb(const GltfContent& content);

/// Writes the .gltf file, its buffer NAME.bin, the texture NAME.png, MIP levels NAME.l.png and the
/// normal map NAME_normal.png, which the caller commits together. Throws Error: io, or unsupported
/// for points beyond the range of 32-bit floats.
std::vector<AtomicFile> write_gltf(const GltfContent& content);

}  // namespace burl
