#pragma once
// Puts a carved mesh into the places of a glTF that it was read from: texture coordinates, indices
// and material of its primitives change, and nothing else does. Attributes keep their bytes; where
// the atlas cuts an edge, those of its middle are means.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/base/atomic_file.h"
#include "app/export/formats.h"
#include "app/kept/document.h"
#include "atlas/build/mesh_atlas.h"
#include "atlas/read/gltf_origins.h"

namespace burl {

/// A mesh on its way back into the document that it was read from.
struct CarvedMesh {
    const GltfOrigins& origins;  ///< of the mesh that was read
    std::span<const CornerOrigin>
        corners;  ///< of the mesh that the atlas places, which is content's
    const SceneContent& content;
    /// The set of texture coordinates that gets the atlas's, where those from it on are moved up by
    /// one; none: the first free one of each primitive. With a uv atlas it is the set that the
    /// atlas was read from, none: 0, and stays as it is.
    std::optional<std::uint32_t> uv_set{};
    /// The path after which pictures beside a .gltf are named; empty: they go into the document.
    std::string pictures{};
    /// Per triangle of the mesh that was read, whose primitives have one label each, the number of
    /// its recipe among content.options.shares; empty: one recipe.
    std::span<const std::uint32_t> labels{};
};

/// Carves the document. Returns the files of the pictures, which are still to be committed. What
/// cannot be kept is added to document.losses. Throws Error(usage) for a `uv_set` that leaves a gap
/// or would move coordinates that material variants read, and io.
std::vector<AtomicFile> carve(KeptDocument& document, const CarvedMesh& carved);

/// Writes the document, without what nothing refers to, as .glb or .gltf with its .bin; images that
/// lie in other folders, or beside, for a .glb, go into it. Throws Error: io, or unsupported for a
/// .glb of more than 4 GiB.
std::vector<AtomicFile> write_kept(KeptDocument& document, const std::string& path);

}  // namespace burl
