#pragma once
// An .exr written in bands of rows while its texture is synthesised: a whole texture of 16384 x
// 16384 texels would take 3 GB.
#include <string>

#include "app/bake/levels.h"

namespace burl {

/// The files of an .exr written in bands.
struct BandsWritten {
    /// Number of MIP levels in the file.
    std::size_t levels = 0;
    std::vector<AtomicFile> files{};  ///< files that are still to be committed
    double seconds = 0.0;             ///< time spent on files, without the pipeline's stages
};

/// Writes the texture of the pipeline's recipe with its levels to `path`, and, if `normals` is not
/// null, the normal map beside it. comes_in_bands must hold (app/bake/texture.h). Throws Error(io).
BandsWritten write_exr_in_bands(Pipeline& pipeline, const std::string& path,
                                const LevelsAsked& levels, const NormalMap* normals);

}  // namespace burl
