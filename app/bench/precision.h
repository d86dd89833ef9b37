#pragma once
// The suite `burl bench precision`: bits of texture coordinate against error, after the precision
// tests of Hart et al. 1999 (section 4.3, figure 10): wood and marble on a torus in fixed point of
// many formats and in float32, held against float64.
#include <string>
#include <vector>

#include "app/bench/bench.h"

namespace burl {

struct PrecisionBench {
    std::string texture;     ///< preset
    std::string precision;   ///< as --precision has it
    double max_error = 0.0;  ///< of f, against float64
    double rms_error = 0.0;
    double psnr = 0.0;  ///< dB, of 8-bit sRGB colours against those of float64; infinite if equal
    /// The same where texture coordinates alone are cut, and all else is float64; fixed only.
    double coordinate_rms_error = 0.0, coordinate_psnr = 0.0;
    BenchRow time{};  ///< one thread, the colour table's making included
};

/// Over the texels of a side x side texture that show the torus; `repeats` paired rounds for times.
std::vector<PrecisionBench> bench_precision(int repeats, std::size_t side = 512);

}  // namespace burl
