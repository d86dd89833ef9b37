#pragma once
// The solid map of an atlas (procedural/batch/point_map.h) as an OpenEXR file, from which a shader
// made of a recipe fills a baked mesh's atlas in another program.
#include <cstdint>
#include <string>
#include <vector>

#include "app/base/atomic_file.h"
#include "procedural/maps/point_map.h"

namespace burl {

class Pipeline;

/// The content of an EXR file: channels X, Y and Z (32-bit floats, the offset from the base), A (1
/// in spans, 0 elsewhere) and owner (32-bit, Span::map or no_owner); the header's "base" is the
/// base in float64. Row 0 on top. Throws Error(runtime) when OpenEXR cannot encode it.
std::vector<std::uint8_t> encode_solid_map(const SolidMap& map, const Vec3d& base);

/// A solid map's base, and its file.
struct WrittenSolidMap {
    Vec3d base{0.0};
    AtomicFile file;  ///< a file yet to be committed
};
/// Writes the solid map of the pipeline's atlas, in its recipe's texture coordinates (after
/// solid.scale). 0 threads means all. Throws Error(io).
WrittenSolidMap write_solid_map(const std::string& path, Pipeline& pipeline, int threads);

}  // namespace burl
