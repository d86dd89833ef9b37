#pragma once
// The texture of an .exr as it is worked out, a band of rows at a time: of 16384 x 16384 texels it
// would be three gigabytes.
#include <string>

#include "app/bake/levels.h"

namespace burl {

struct BandsWritten {
    std::size_t levels = 0;
    std::vector<AtomicFile> files{};  ///< to be committed
    double seconds = 0.0;             ///< without what stages of the pipeline took
};

/// Where comes_in_bands (app/bake/texture.h): the texture of the pipeline's recipe with its levels,
/// and beside it the normal map if there is one.
BandsWritten write_exr_in_bands(Pipeline& pipeline, const std::string& path,
                                const LevelsAsked& levels, const NormalMap* normals);

}  // namespace burl
