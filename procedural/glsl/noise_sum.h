#pragma once
// Sums of octaves as GLSL, of values or with gradients. Where the noise has a kernel, coordinates
// are split once for several octaves, as in kernels/noise_sum.h; elsewhere they are split octave by
// octave.
#include <array>
#include <map>

#include "procedural/glsl/functions.h"

namespace burl {

/// The lines of a sum in a function's body, and the expression of its result.
struct GlslSum {
    std::string lines;
    std::string result;
};

/// The sums of one function's body.
class GlslNoiseSums {
  public:
    /// The coordinates of a point: operands of type `real`.
    using Point = std::vector<std::string>;

    explicit GlslNoiseSums(GlslFunctions& functions) : functions_(functions) {}

    /// The sum add_up as an expression of type `real`. `total` is the name of a variable that the
    /// lines may define. The sum must have an octave.
    GlslSum values(const NoiseSum& sum, const Point& point, const std::string& total);

    /// The sum add_up_slopes as a vec4 of the sum, without its offset, and its derivatives along
    /// the point's coordinates. `kept` names a float with the number of octaves that show; empty:
    /// all show.
    GlslSum slopes(const NoiseSum& sum, const Point& point, const std::string& kept, double mean,
                   const std::string& total);

  private:
    struct Octaves;
    std::string doubling_lines(const Octaves& octaves, const Point& point,
                               const std::string& total);
    std::string apart_lines(const Octaves& octaves, const Point& point, const std::string& total);
    std::string sum_line(const Octaves& octaves, const std::string& split,
                         const std::string& total);
    std::string split_lines(const Octaves& all, const Point& point, const std::string& total);
    std::string site_noise(const NoiseSum& sum, const Point& point, bool sloped);

    GlslFunctions& functions_;
    std::map<std::string, std::string> splits_;  ///< variables of split points by expression
};

}  // namespace burl
