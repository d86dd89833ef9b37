#pragma once
// The suite `burl bench precision`: error by the number of bits of texture coordinates, after Hart
// et al. 1999 (section 4.3, figure 10): wood and marble on a torus in many fixed-point formats and
// in float32, compared with float64.
#include <string>
#include <vector>

#include "app/bench/bench.h"

namespace burl {

/// The results of one texture at one precision.
struct PrecisionBench {
    std::string texture;     ///< name of the preset
    std::string precision;   ///< value of --precision
    double max_error = 0.0;  ///< largest error of f against float64
    double rms_error = 0.0;
    /// PSNR of the 8-bit sRGB colours against float64 in dB; infinite if all are equal.
    double psnr = 0.0;
    /// RMS error and PSNR with only the texture coordinates truncated and all else in float64;
    /// fixed-point formats only.
    double coordinate_rms_error = 0.0, coordinate_psnr = 0.0;
    BenchRow time{};  ///< time on one thread, including the construction of the colour table
};

/// Measures the texels that show the torus in a texture of side x side texels; times are of
/// `repeats` paired rounds.
std::vector<PrecisionBench> bench_precision(int repeats, std::size_t side = 512);

}  // namespace burl
