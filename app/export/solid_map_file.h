#pragma once
// The solid map of an atlas (procedural/batch/point_map.h) as an OpenEXR file: with it, a shader
// made of a recipe textures a baked mesh's atlas in another program.
#include <cstdint>
#include <string>
#include <vector>

#include "app/base/atomic_file.h"
#include "procedural/maps/point_map.h"

namespace burl {

class Pipeline;

/// EXR file content: channels X, Y and Z (32-bit floats, the offset from the base), A (1 in spans,
/// 0 elsewhere) and owner (32-bit, Span::map or no_owner); the header's "base" is the base in
/// float64. Row 0 on top. Throws Error(runtime) when OpenEXR cannot encode it.
std::vector<std::uint8_t> encode_solid_map(const SolidMap& map, const Vec3d& base);

/// That of the pipeline's atlas in a file, in its recipe's texture coordinates (after solid.scale).
/// Throws Error(io).
struct WrittenSolidMap {
    Vec3d base{0.0};
    AtomicFile file;  ///< to be committed
};
WrittenSolidMap write_solid_map(const std::string& path, Pipeline& pipeline, int threads);

}  // namespace burl
