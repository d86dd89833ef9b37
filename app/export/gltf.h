#pragma once
// glTF 2.0 output: JSON and buffers written by us, so that the texture is a plain bufferView (not a
// data URI), bounds are those of the floats written, and every byte goes through AtomicFile.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/base/atomic_file.h"
#include "app/base/byte_sink.h"
#include "app/export/vertices.h"
#include "atlas/mesh/mesh.h"
#include "atlas/solid/atlas.h"

namespace burl {

/// How the vertices' targets are called, and how far they go.
struct GltfTarget {
    std::string name{};
    double weight = 0.0;  ///< 0 to 1
};

/// What a glTF file is made of; images are file contents.
struct GltfContent {
    std::string path;  ///< of the file, which errors name
    const Mesh& mesh;
    std::span<const PartVertices> vertices;
    const AtlasOptions& atlas;
    std::string name;  ///< of the material and, with what sets them apart, the images
    ByteSource png;
    std::span<const ByteSource> levels;  ///< PNGs of MIP levels 1, 2, ...
    std::string recipe_json;             ///< for asset.extras; may be empty
    ByteSource normal_png{};  ///< in tangent space, for vertices with tangents; may be empty
    GltfTarget target{};      ///< of vertices that have one
};

/// One file with everything in it, images last; it has yet to be committed. Throws Error: io, or
/// unsupported beyond 4 GiB and for points that 32-bit floats cannot hold.
AtomicFile write_glb(const GltfContent& content);

/// The file, the buffer beside it in NAME.bin, the texture in NAME.png, MIP level l in NAME.l.png
/// and the normal map in NAME_normal.png; they have yet to be committed together. Throws Error: io,
/// or unsupported for such points.
std::vector<AtomicFile> write_gltf(const GltfContent& content);

}  // namespace burl
